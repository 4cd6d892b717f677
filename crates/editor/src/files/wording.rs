//! What is wrong with a file, in the language of the window.

use crate::tr;
use std::path::Path;
use vitrine::formats::FormatError;

/// The message and the help for an error. What a reader says of the inside of a file stays in its own words.
pub fn describe(error: &FormatError) -> (String, String) {
    let at = |path: &Path| path.display().to_string();
    match error {
        FormatError::Missing { path } => pair("missing", tr!("files-missing", path = at(path))),
        FormatError::NotAFile { path, .. } => pair("not-a-file", tr!("files-not-a-file", path = at(path))),
        FormatError::Unreadable { path, cause } => {
            pair("unreadable", tr!("files-unreadable", path = at(path), cause = cause.to_string()))
        }
        FormatError::TooLarge { path, limit } => {
            pair("too-large", tr!("files-too-large", path = at(path), limit = limit >> 20))
        }
        FormatError::NotText { path, .. } => pair("not-text", tr!("files-not-text", path = at(path))),
        FormatError::UnknownExtension { path, supported, .. } => {
            let help = tr!("files-unknown-extension.help", supported = supported.as_str());
            (tr!("files-unknown-extension", path = at(path)), help)
        }
        FormatError::Model { path, reason, help } => {
            (tr!("files-model", path = at(path), reason = reason.as_str()), help.clone())
        }
        FormatError::ModelLine { path, line, reason, help } => {
            let message =
                tr!("files-model-line", path = at(path), line = line.to_string(), reason = reason.as_str());
            (message, help.clone())
        }
        FormatError::NotAPicture { path, .. } => {
            pair("not-a-picture", tr!("files-not-a-picture", path = at(path)))
        }
        FormatError::PictureCutOff { path } => {
            pair("picture-cut-off", tr!("files-picture-cut-off", path = at(path)))
        }
        FormatError::PictureTooLarge { path, width, height } => {
            let message = tr!("files-picture-too-large", path = at(path), width = *width, height = *height);
            pair("picture-too-large", message)
        }
        FormatError::PictureDamaged { path, reason } => {
            let message = tr!("files-picture-damaged", path = at(path), reason = reason.as_str());
            pair("picture-damaged", message)
        }
        FormatError::Encode { format, reason } => {
            pair("encode", tr!("files-encode", format = *format, reason = reason.as_str()))
        }
        FormatError::MissingFolder { folder } => {
            pair("missing-folder", tr!("files-missing-folder", path = at(folder)))
        }
        FormatError::DiscFull { path } => pair("disc-full", tr!("files-disc-full", path = at(path))),
        FormatError::Unwritable { path, cause } => {
            pair("unwritable", tr!("files-unwritable", path = at(path), cause = cause.to_string()))
        }
        FormatError::Asset { owner, cause } => {
            let (message, help) = describe(cause);
            (format!("{owner}: {message}"), help)
        }
        FormatError::EmptyPath => pair("empty-path", tr!("files-empty-path")),
        other => (other.to_string(), other.help()),
    }
}

fn pair(key: &str, message: String) -> (String, String) {
    (message, tr!(&format!("files-{key}.help")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::{Language, set_language};

    #[test]
    fn every_error_has_words_in_both_languages() {
        let path = || std::path::PathBuf::from("a.obj");
        let cause = || std::io::Error::other("why");
        let errors = [
            FormatError::Missing { path: path() },
            FormatError::NotAFile { path: path(), what: "a folder" },
            FormatError::Unreadable { path: path(), cause: cause() },
            FormatError::TooLarge { path: path(), limit: 1 << 20 },
            FormatError::NotText { path: path(), position: 0, byte: 0xff },
            FormatError::UnknownExtension { path: path(), what: "a model", supported: ".obj".into() },
            FormatError::Model { path: path(), reason: "r".into(), help: "h".into() },
            FormatError::ModelLine { path: path(), line: 3, reason: "r".into(), help: "h".into() },
            FormatError::NotAPicture { path: path(), found: None },
            FormatError::PictureCutOff { path: path() },
            FormatError::PictureTooLarge { path: path(), width: 9, height: 9 },
            FormatError::PictureDamaged { path: path(), reason: "r".into() },
            FormatError::Encode { format: "JPEG", reason: "r".into() },
            FormatError::MissingFolder { folder: path() },
            FormatError::DiscFull { path: path() },
            FormatError::Unwritable { path: path(), cause: cause() },
            FormatError::EmptyPath,
        ];
        for error in &errors {
            let texts = Language::ALL.map(|language| {
                set_language(language);
                describe(error)
            });
            for (message, help) in &texts {
                assert!(!message.contains("files-") && !help.contains("files-"), "{message} / {help}");
            }
            assert_ne!(texts[0].0, texts[1].0, "{error}");
        }
        set_language(Language::English);
    }
}
