//! The form for people, as in the style guide: title, place, underlined source, notes, helps.

use annotate_snippets::{Annotation, AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

use super::range;
use crate::{Diagnostic, FileId, Label, Severity, Sources};

/// A longer line is shown in part; files without line breaks exist.
const LONGEST_LINE: usize = 1000;
/// How much of a long line is shown on each side of the place.
const AROUND: usize = 50;

/// One diagnostic, ending in a line break.
pub(super) fn block(sources: &Sources, diagnostic: &Diagnostic, colours: bool) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let mut group = level.primary_title(&diagnostic.message).id(diagnostic.code).elements(Vec::<Element>::new());
    if let Some(primary) = &diagnostic.primary {
        group = with_source(group, sources, primary, &diagnostic.secondary);
    }
    for note in &diagnostic.notes {
        group = group.element(Level::NOTE.message(note));
    }
    for help in &diagnostic.helps {
        group = group.element(Level::HELP.message(&help.text));
    }
    let renderer = if colours { Renderer::styled() } else { Renderer::plain() };
    let mut text = renderer.render(&[group]);
    if diagnostic.primary.is_none() {
        // Without source there is nothing for the renderer's empty gutter line to lead to.
        text = text.lines().filter(|line| plain(line).trim() != "|").collect::<Vec<_>>().join("\n");
    }
    text.push('\n');
    text
}

/// Adds the source of the primary label's file, then that of every other file that has labels.
fn with_source<'a>(
    mut group: Group<'a>,
    sources: &'a Sources,
    primary: &'a Label,
    secondary: &'a [Label],
) -> Group<'a> {
    let mut files = vec![primary.span.file];
    for label in secondary {
        if !files.contains(&label.span.file) {
            files.push(label.span.file);
        }
    }
    for file in files {
        let labels: Vec<(AnnotationKind, &Label)> = std::iter::once((AnnotationKind::Primary, primary))
            .chain(secondary.iter().map(|label| (AnnotationKind::Context, label)))
            .filter(|(_, label)| label.span.file == file)
            .collect();
        group = with_file(group, sources, file, &labels);
    }
    group
}

fn with_file<'a>(
    group: Group<'a>,
    sources: &'a Sources,
    file: FileId,
    labels: &[(AnnotationKind, &'a Label)],
) -> Group<'a> {
    let text = sources.text(file);
    let start = labels.iter().map(|(_, l)| sources.line_range(file, l.span.start).start).min().unwrap_or(0);
    let end = labels.iter().map(|(_, l)| sources.line_range(file, l.span.end).end).max().unwrap_or(0).max(start);
    let Some(source) = text.get(start..end) else { return group };
    if source.lines().all(|line| line.len() <= LONGEST_LINE) {
        let annotations = labels.iter().map(|(kind, label)| annotation(*kind, label, start, source.len()));
        let snippet = Snippet::source(source)
            .path(sources.name(file))
            .line_start(sources.line_column(file, start as u32).line)
            .annotations(annotations);
        return group.element(snippet);
    }
    // Only the first label, in a window of its line, under the true position.
    let Some((kind, label)) = labels.first() else { return group };
    let (from, _) = range(sources, label.span);
    let line = sources.line_range(file, label.span.start);
    let at = label.span.start as usize;
    let boundary = |from: usize| (from..=text.len()).find(|i| text.is_char_boundary(*i)).unwrap_or(text.len());
    let window_start = boundary(at.saturating_sub(AROUND).max(line.start));
    let window_end = boundary((label.span.end as usize + AROUND).min(at + 2 * AROUND).min(line.end));
    let Some(window) = text.get(window_start..window_end) else { return group };
    let origin = Origin::path(sources.name(file)).line(from.line).char_column(from.column);
    let annotations = [annotation(*kind, label, window_start, window.len())];
    group.element(origin).element(Snippet::source(window).line_start(from.line).annotations(annotations))
}

fn annotation(kind: AnnotationKind, label: &Label, window_start: usize, length: usize) -> Annotation<'_> {
    let clamp = |offset: u32| (offset as usize).saturating_sub(window_start).min(length);
    let annotation = kind.span(clamp(label.span.start)..clamp(label.span.end));
    if label.text.is_empty() { annotation } else { annotation.label(&label.text) }
}

/// A line without colour sequences.
fn plain(line: &str) -> String {
    let mut text = String::with_capacity(line.len());
    let mut rest = line;
    while let Some(start) = rest.find('\u{1b}') {
        text.push_str(&rest[..start]);
        rest = rest[start..].find('m').map_or("", |end| &rest[start + end + 1..]);
    }
    text.push_str(rest);
    text
}
