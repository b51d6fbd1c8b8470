"""Fonts that travel with the pages: cut down to the characters in use, and written into the style
sheet, because a page opened from disk may not read fonts beside it."""

from __future__ import annotations

import base64
import io
from importlib.util import find_spec
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont


def _folder(package: str) -> Path:
    """Where a package of fonts is; it need not be imported for that."""
    return Path(find_spec(package).origin).parent


_SANS = _folder("font_source_sans_pro") / "files"
_SERIF = _folder("font_source_serif_pro") / "files"
_MATH = _folder("ziamath") / "fonts" / "STIXTwoMath-Regular.ttf"

# family, weight, style, file
FACES = [
    ("Source Serif", 400, "normal", _SERIF / "SourceSerifPro-Regular.ttf"),
    ("Source Serif", 400, "italic", _SERIF / "SourceSerifPro-It.ttf"),
    ("Source Serif", 600, "normal", _SERIF / "SourceSerifPro-Semibold.ttf"),
    ("Source Sans", 400, "normal", _SANS / "SourceSansPro-Regular.ttf"),
    ("Source Sans", 400, "italic", _SANS / "SourceSansPro-It.ttf"),
    ("Source Sans", 600, "normal", _SANS / "SourceSansPro-Semibold.ttf"),
    ("STIX Two Math", 400, "normal", _MATH),
]
# All three are under the SIL Open Font License, which travels with them.
LICENCES = {"OFL-source-sans.txt": _SANS / "LICENSE.txt", "OFL-source-serif.txt": _SERIF / "LICENSE.txt"}
CHART_FONT = _SANS / "SourceSansPro-Regular.ttf"
# Kerning, figures of tables and texts, and what formulas need: smaller scripts, letters without dots.
_FEATURES = ["kern", "liga", "tnum", "lnum", "mark", "mkmk", "ccmp", "ssty", "dtls"]


def style_sheet(characters: set[int]) -> str:
    """`@font-face` rules with the fonts in them, cut down to these characters and what always counts:
    ASCII, and the root that stands in no text."""
    wanted = sorted(characters | set(range(0x20, 0x7F)) | {0x221A})
    rules = []
    for family, weight, style, path in FACES:
        data = base64.b64encode(_cut(path, wanted)).decode()
        rules.append(
            f'@font-face{{font-family:"{family}";font-weight:{weight};font-style:{style};'
            f"font-display:block;src:url(data:font/woff2;base64,{data})format('woff2')}}"
        )
    return "\n".join(rules)


def _cut(path: Path, characters: list[int]) -> bytes:
    # The time stamp of the file would be that of the build.
    font = TTFont(path, recalcTimestamp=False)
    options = subset.Options(
        flavor="woff2", layout_features=_FEATURES, hinting=False, notdef_outline=True, name_IDs=["*"]
    )
    options.drop_tables += ["FFTM", "DSIG"]
    cutter = subset.Subsetter(options)
    cutter.populate(unicodes=characters)
    cutter.subset(font)
    font.flavor = "woff2"
    out = io.BytesIO()
    font.save(out)
    return out.getvalue()
