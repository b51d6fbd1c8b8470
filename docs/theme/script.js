// Light and dark by hand, and the place in the contents. The pages are whole without it.
const root = document.documentElement;
document.getElementById("theme").addEventListener("click", () => {
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
  localStorage.setItem("flexure-theme", root.dataset.theme);
});

const contents = document.querySelector("aside details");
if (matchMedia("(max-width: 64rem)").matches) contents.open = false;

const links = new Map([...document.querySelectorAll("aside a")].map((a) => [a.hash.slice(1), a]));
const headings = [...document.querySelectorAll("main h2, main h3")];
const mark = () => {
  const passed = headings.filter((h) => h.getBoundingClientRect().top < 120).pop();
  for (const [name, a] of links) a.toggleAttribute("aria-current", passed !== undefined && name === passed.id);
};
addEventListener("scroll", mark, { passive: true });
mark();
