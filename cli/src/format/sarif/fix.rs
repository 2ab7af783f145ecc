//! A safe cure as SARIF has it: a service offers it as a suggestion.

use std::path::Path;

use lexican_eds::{
    diagnostic::Diagnostic,
    document::Document,
    fix::{self, Fix},
    source::Source,
    span::Span,
};

use super::{
    location::uri,
    log::{ArtifactChange, ArtifactContent, ArtifactLocation, DeletedRegion, Message, Replacement, SarifFix},
};

/// The cure of `finding`; `None` for one of the file as a whole or of its lists, which is left to `--fix`.
pub(super) fn of(document: &Document, finding: &Diagnostic, cure: &Fix) -> Option<SarifFix> {
    let source = document.source();
    let replacements: Vec<Replacement> = cure
        .replacements(document)
        .into_iter()
        .map(|replacement| of_text(source, replacement))
        .collect();
    (!replacements.is_empty()).then(|| SarifFix {
        description: finding.help.as_deref().map(Message::literal),
        artifact_changes: [ArtifactChange {
            artifact_location: ArtifactLocation {
                uri: uri(Path::new(source.name())),
            },
            replacements,
        }],
    })
}

fn of_text(source: &Source, fix::Replacement { at, text }: fix::Replacement) -> Replacement {
    let (start_line, start_column) = edge(source, at.start);
    let (end_line, end_column) = edge(source, at.end);
    Replacement {
        deleted_region: DeletedRegion {
            start_line,
            start_column,
            end_line,
            end_column,
        },
        inserted_content: (!text.is_empty()).then_some(ArtifactContent { text }),
    }
}

/// Line and column of an offset; behind the last line end a new line starts.
fn edge(source: &Source, offset: u32) -> (u32, u32) {
    let text = source.text();
    if offset as usize == text.len() && (text.is_empty() || text.ends_with(['\r', '\n'])) {
        return (source.line_count() + 1, 1);
    }
    let place = source.line_column(Span::new(offset, offset));
    (place.line, place.column)
}
