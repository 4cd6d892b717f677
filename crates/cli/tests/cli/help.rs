//! What the program says of itself.

use crate::support::Folder;

const COMMANDS: [&[&str]; 12] = [
    &["edit"],
    &["render"],
    &["check"],
    &["info"],
    &["denoise"],
    &["sweep"],
    &["bench", "threads"],
    &["bench", "kernel"],
    &["templates"],
    &["schema"],
    &["completions"],
    &["man"],
];

/// Whatever display there is, the program must believe that there is none.
#[test]
fn without_a_display_it_says_so_and_points_to_what_works() {
    let folder = Folder::new();
    for arguments in [&[][..], &["edit"]] {
        let mut command = folder.command();
        command
            .args(arguments)
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET");
        let output = command.output().unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{told}");
        assert!(told.contains("window") && told.contains("vitrine render"), "{told}");
        assert!(!told.contains("panicked"), "{told}");
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn every_command_has_help_with_examples() {
    let folder = Folder::new();
    let overview = folder.run_well(&["--help"]).out;
    for command in COMMANDS {
        assert!(overview.contains(command[0]), "{command:?}");
        for flag in ["-h", "--help"] {
            let help = folder.run_well(&[command, &[flag]].concat()).out;
            let example = format!("  vitrine {}", command.join(" "));
            assert!(help.contains("Example") && help.contains(&example), "{help}");
        }
    }
}

#[test]
fn the_version_is_the_librarys() {
    let outcome = Folder::new().run_well(&["--version"]);
    assert_eq!(outcome.out, format!("vitrine {}\n", vitrine::VERSION));
}

#[test]
fn an_unknown_command_is_met_with_a_near_one() {
    Folder::new().run(&["rendr"]).fails(2, &["rendr", "render"]);
}

#[test]
fn completions_for_every_shell() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let outcome = folder.run_well(&["completions", shell]);
        assert!(outcome.out.contains("sweep") && outcome.out.contains("samples"), "{shell}");
    }
}

#[test]
fn the_manual_has_every_command() {
    let manual = Folder::new().run_well(&["man"]).out;
    assert!(manual.contains(".TH vitrine 1"), "{manual}");
    for command in COMMANDS {
        let heading = format!(".SH \"VITRINE {}\"", command.join(" ").to_uppercase());
        assert!(manual.contains(&heading), "{heading}");
    }
}

/// `vitrine schema | head -1`: the reader goes away before the end.
#[test]
#[cfg(unix)]
fn a_reader_that_goes_away_is_no_failure() {
    use std::io::Read;
    use std::process::Stdio;
    let folder = Folder::new();
    let mut child =
        folder.command().arg("schema").stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let mut told = String::new();
    child.stderr.take().unwrap().read_to_string(&mut told).unwrap();
    assert_eq!((child.wait().unwrap().code(), told.as_str()), (Some(0), ""));
}
