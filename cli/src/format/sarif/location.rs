//! Places as SARIF has them.

use std::path::{Component, Path};

use lexican_eds::{source::Source, span::Span};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

use super::log::{ArtifactLocation, Location, LogicalLocation, PhysicalLocation, Region};
use crate::format::place::Place;

/// `span` of a file, or the file as a whole, and the section that it is in.
pub(super) fn of<'a>(source: &Source, span: Option<Span>, section: Option<&'a str>) -> Location<'a> {
    let uri = uri(Path::new(source.name()));
    Location {
        physical_location: PhysicalLocation {
            artifact_location: ArtifactLocation { uri },
            region: span.map(|span| Place::of(source, span).into()),
        },
        logical_locations: section.map(|fully_qualified_name| [LogicalLocation { fully_qualified_name }]),
    }
}

impl From<Place> for Region {
    fn from(place: Place) -> Self {
        Self {
            start_line: place.line,
            start_column: place.column,
            end_column: place.end_column,
        }
    }
}

/// What RFC 3986 lets stand in a segment of a path, apart from letters and digits.
const ESCAPED: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'~');

/// A relative reference for a relative path: a service looks for it from the root of the repository.
pub(super) fn uri(path: &Path) -> String {
    let mut uri = String::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::RootDir => uri.push('/'),
            Component::Prefix(prefix) => uri = format!("file:///{}", prefix.as_os_str().to_string_lossy()),
            Component::ParentDir => push(&mut uri, ".."),
            Component::Normal(name) => push(&mut uri, &name.to_string_lossy()),
        }
    }
    if uri.starts_with('/') {
        format!("file://{uri}")
    } else {
        uri
    }
}

fn push(uri: &mut String, segment: &str) {
    if !uri.is_empty() && !uri.ends_with('/') {
        uri.push('/');
    }
    uri.extend(utf8_percent_encode(segment, ESCAPED));
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::uri;

    #[test]
    fn a_path_becomes_a_reference_without_a_character_that_means_something_else() {
        assert_eq!(uri(Path::new("devices/pump.eds")), "devices/pump.eds");
        assert_eq!(
            uri(Path::new("./devices/../Pumpe 1#%.eds")),
            "devices/../Pumpe%201%23%25.eds"
        );
        assert_eq!(uri(Path::new("größe.eds")), "gr%C3%B6%C3%9Fe.eds");
        assert_eq!(uri(Path::new("<stdin>")), "%3Cstdin%3E");
    }

    #[cfg(unix)]
    #[test]
    fn an_absolute_path_is_an_uri_of_its_own() {
        assert_eq!(uri(Path::new("/home/me/pump.eds")), "file:///home/me/pump.eds");
    }
}
