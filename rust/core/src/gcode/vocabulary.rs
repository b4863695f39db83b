//! What commands do that [`machine`](super::machine) does not carry out: the one list.
//!
//! Sources: marlinfw.org/meta/gcode; docs.duet3d.com, "GCode dictionary"; Repetier-Firmware,
//! Repetier.ino; klipper3d.org/G-Codes.html; help.prusa3d.com, "Prusa firmware-specific G-code
//! commands".

use super::command::{Command, Words};
use super::dialect::Dialect;

/// What a command does to the head, the bed and the frame of coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// Nothing: it heats, blows, waits, reports, shows or sets a limit.
    Harmless,
    /// It moves the head somewhere, or learns how the bed lies: no harm before anything is printed.
    Prepares,
    /// It does, or may do, something that is not known here; why.
    Unknown(&'static str),
}

/// Heaters, fans, lights, messages, waits, reports, limits, motors on and off.
const HARMLESS_M: &[u32] = &[
    17, 18, 20, 21, 22, 27, 29, 30, 31, 36, 42, 70, 72, 73, 74, 75, 76, 77, 78, 80, 81, 84, 85,
    104, 105, 106, 107, 108, 109, 110, 111, 113, 114, 115, 116, 117, 118, 119, 122, 123, 140, 141,
    143, 144, 150, 154, 155, 190, 191, 192, 200, 201, 202, 203, 204, 205, 207, 210, 211, 250, 256,
    259, 300, 301, 302, 304, 305, 308, 309, 310, 355, 400, 404, 405, 406, 407, 412, 413, 500, 503,
    504, 550, 552, 555, 562, 564, 566, 568, 569, 570, 571, 572, 573, 575, 591, 593, 710, 862, 900,
    905, 909, 911, 912, 914, 919, 950, 951,
];

/// G60 keeps a place, without going there; G94 is how speeds are told anyway.
const HARMLESS_G: &[u32] = &[21, 60, 94];

/// Klipper's own commands that move nothing.
const HARMLESS_NAMED: &[&str] = &[
    "ECHO",
    "EXCLUDE_OBJECT_DEFINE",
    "EXCLUDE_OBJECT_END",
    "EXCLUDE_OBJECT_START",
    "GET_POSITION",
    "GET_RETRACTION",
    "HELP",
    "QUERY_ENDSTOPS",
    "QUERY_FILAMENT_SENSOR",
    "QUERY_PROBE",
    "RESPOND",
    "SAVE_GCODE_STATE",
    "SAVE_VARIABLE",
    "SET_DISPLAY_GROUP",
    "SET_DISPLAY_TEXT",
    "SET_FAN_SPEED",
    "SET_FILAMENT_SENSOR",
    "SET_GCODE_VARIABLE",
    "SET_HEATER_TEMPERATURE",
    "SET_IDLE_TIMEOUT",
    "SET_INPUT_SHAPER",
    "SET_LED",
    "SET_LED_TEMPLATE",
    "SET_PIN",
    "SET_PRESSURE_ADVANCE",
    "SET_PRINT_STATS_INFO",
    "SET_RETRACTION",
    "SET_SMOOTH_TIME",
    "SET_TEMPERATURE_FAN_TARGET",
    "SET_VELOCITY_LIMIT",
    "STATUS",
    "TEMPERATURE_WAIT",
    "TURN_OFF_HEATERS",
];

/// They probe, level, calibrate, clean, load filament, set the currents by which motors keep their
/// place, or run a macro of the printer's.
const PREPARES_G: &[u32] = &[12, 29, 30, 31, 32, 33, 34, 35, 76, 80, 81, PRIMES];
/// Ultimaker's priming (CuraEngine writes it first); those printers heat and home ahead of a file.
const PRIMES: u32 = 280;
const PREPARES_M: &[u32] = &[
    48, 98, 280, 320, 321, 322, 323, 374, 375, 376, 401, 402, 420, 421, 557, 558, 561, 701, 702,
    703, 906, 907, 908, 910, 913, 915,
];

/// They move the frame of coordinates, or how far a step goes.
const FRAME_G: &[u32] = &[10, 51, 52, 54, 55, 56, 57, 58, 59, 68, 69];
const FRAME_M: &[u32] = &[
    92, 206, 218, 290, 350, 425, 428, 450, 451, 452, 453, 501, 502, 556, 563, 574, 579, 584, 585,
    665, 666, 667, 669, 671, 851, 852,
];
const FRAME_NAMED: &[&str] = &[
    "ACTIVATE_EXTRUDER",
    "BED_TILT_CALIBRATE",
    "RESTORE_GCODE_STATE",
    "SET_DUAL_CARRIAGE",
    "SET_EXTRUDER_ROTATION_DISTANCE",
    "SET_GCODE_OFFSET",
    "SET_KINEMATIC_POSITION",
    "SET_SKEW",
    "SKEW_PROFILE",
    "SYNC_EXTRUDER_MOTION",
    "SYNC_STEPPER_TO_EXTRUDER",
    "Z_OFFSET_APPLY_ENDSTOP",
    "Z_OFFSET_APPLY_PROBE",
];

/// `RepRapFirmware`'s words of conditions and loops, which are small letters.
const CONDITIONAL: &[&[u8]] =
    &[b"if", b"elif", b"else", b"while", b"break", b"continue", b"abort", b"return"];

/// What follows these is text, in which a letter is no word.
const TEXT_M: &[u32] = &[20, 23, 28, 29, 30, 32, 36, 70, 72, 98, 117, 118, 550, 552, 928];

const FRAME: &str = "it moves the frame of coordinates";
const MOVES: &str = "it may move the head";
const MACRO: &str = "what this macro does is not known once the print has begun";
/// Why a line with two commands is not judged.
pub const SECOND: &str = "a second command stands in its line";
/// Why a homing with other words than axes is not.
pub const HOMING_WORD: &str = "how this word changes the way home is not known";
const DIRECTION: &str = "it may turn a motor's direction";
const LEAVES_OUT: &str = "what follows may be left out";
const TUNES: &str = "it heats and cools the nozzle at its own will";
const FACTOR: &str = "firmwares refuse it, or nothing moves or comes out any more";
const DRY: &str = "the firmware may do as if it printed, and print nothing";
const CONDITION: &str = "whether what follows is carried out is not known";
const HOST: &str = "the host may pause, cancel or move at this word";

/// What a command does that the machine reports as somebody else's.
#[must_use]
pub fn effect(command: &Command<'_>, dialect: Dialect) -> Effect {
    match *command {
        Command::G(code, words) => of_g(code, words, dialect),
        Command::M(code, words) => of_m(code, words, dialect),
        Command::Sub(letter, code, _) => of_sub(letter, code),
        Command::Named(name, words) => of_named(name, words),
        Command::Units { inches: true, .. } if dialect == Dialect::Klipper => {
            Effect::Unknown("Klipper knows no inches")
        }
        Command::Units { .. } => Effect::Harmless,
        _ => Effect::Unknown(MOVES),
    }
}

fn of_g(code: u32, words: Words<'_>, dialect: Dialect) -> Effect {
    // G10 P0 S210 sets a tool's temperature in RepRapFirmware.
    let heats = code == 10 && words.letters().all(|word| b"PRS".contains(&word));
    match code {
        53 if dialect == Dialect::Klipper => Effect::Unknown("Klipper has no G53"),
        53 => Effect::Unknown("firmwares differ in what G53 is after G92, or without a move"),
        _ if heats => Effect::Harmless,
        _ if HARMLESS_G.contains(&code) => Effect::Harmless,
        _ if PREPARES_G.contains(&code) => Effect::Prepares,
        _ if FRAME_G.contains(&code) => Effect::Unknown(FRAME),
        _ => Effect::Unknown(MOVES),
    }
}

fn of_m(code: u32, words: Words<'_>, dialect: Dialect) -> Effect {
    // Behind A stands a name.
    let leaves_out =
        || words.letters().take_while(|word| *word != b'A').any(|w| b"CP".contains(&w));
    match code {
        200 if dialect == Dialect::Klipper => Effect::Unknown("Klipper has no M200"),
        // The axes' travel, in RepRapFirmware; what M209 retracts, no G10 says.
        209 if words.get(b'S').unwrap_or(0.0) > 0.0 => {
            Effect::Unknown("it makes retractions of moves of E")
        }
        209 => Effect::Harmless,
        // RepRapFirmware's ends of the axes, where they are after homing; Marlin's has no axes.
        208 if words.letters().any(|word| b"XYZUVW".contains(&word)) => Effect::Unknown(FRAME),
        208 => Effect::Harmless,
        303 => Effect::Unknown(TUNES),
        220 | 221 => Effect::Unknown(FACTOR),
        // Marlin's and Repetier's flags: 8 feeds nothing, 16 and 32 move nothing.
        111 if words.get(b'S').is_some_and(|flags| flags >= 8.0) => Effect::Unknown(DRY),
        118 if commands_the_host(words) => Effect::Unknown(HOST),
        486 if leaves_out() => Effect::Unknown(LEAVES_OUT),
        486 => Effect::Harmless,
        // Marlin's chooses how silent a driver is; with P it is RepRapFirmware's.
        569 if words.has(b'P') && words.has(b'S') => Effect::Unknown(DIRECTION),
        _ if HARMLESS_M.contains(&code) => Effect::Harmless,
        _ if PREPARES_M.contains(&code) => Effect::Prepares,
        _ if FRAME_M.contains(&code) => Effect::Unknown(FRAME),
        _ => Effect::Unknown(MOVES),
    }
}

/// Codes with a decimal: Prusa's checks of printer and nozzle.
fn of_sub(letter: u8, code: &[u8]) -> Effect {
    let whole = code.split(|byte| *byte == b'.').next().unwrap_or_default();
    match (letter, whole) {
        (b'M', b"862") => Effect::Harmless,
        (b'G', b"29" | b"30" | b"33" | b"80") => Effect::Prepares,
        _ => Effect::Unknown(MOVES),
    }
}

fn of_named(name: &[u8], words: Words<'_>) -> Effect {
    let is_one_of = |names: &[&str]| names.iter().any(|n| name.eq_ignore_ascii_case(n.as_bytes()));
    if name.eq_ignore_ascii_case(b"RESPOND") && commands_the_host(words) {
        Effect::Unknown(HOST)
    } else if name.eq_ignore_ascii_case(b"EXCLUDE_OBJECT") && !words.0.trim_ascii().is_empty() {
        Effect::Unknown(LEAVES_OUT)
    } else if CONDITIONAL.contains(&name) {
        Effect::Unknown(CONDITION)
    } else if is_one_of(HARMLESS_NAMED) {
        Effect::Harmless
    } else if is_one_of(FRAME_NAMED) {
        Effect::Unknown(FRAME)
    } else {
        Effect::Prepares
    }
}

/// Whether a message is a command to the host (`action:pause`), and none that only shows something.
///
/// Source: docs.octoprint.org, "Action commands".
fn commands_the_host(words: Words<'_>) -> bool {
    const SHOWN: [&str; 2] = ["notification", "prompt"];
    let text = String::from_utf8_lossy(words.0).to_ascii_lowercase();
    text.split("action:").skip(1).any(|word| {
        let word = word.trim_start();
        !SHOWN.iter().any(|shown| word.starts_with(shown))
    })
}

/// Why a command that only prepares a print is not known within one.
#[must_use]
pub fn within_a_print(command: &Command<'_>) -> &'static str {
    if matches!(command, Command::Named(..)) { MACRO } else { MOVES }
}

/// Whether a G or M with a number follows, outside of quotes: a command more to some firmwares.
#[must_use]
pub fn has_second_command(command: &Command<'_>) -> bool {
    match *command {
        Command::G(53, _) | Command::Named(..) => return false,
        Command::M(code, _) if TEXT_M.contains(&code) => return false,
        _ => {}
    }
    let words = command.words();
    let mut quoted = false;
    let mut letter = false;
    words.0.iter().any(|byte| {
        quoted ^= *byte == b'"';
        let found = letter && byte.is_ascii_digit();
        letter = !quoted && matches!(byte.to_ascii_uppercase(), b'G' | b'M');
        found
    })
}

/// Whether a homing has words that may change its way: others than axes and those that tell what
/// becomes of a mesh of the bed. Marlin's O, "only what is not home", others do not know.
#[must_use]
pub fn homes_otherwise(command: &Command<'_>) -> bool {
    matches!(command, Command::Home { words, .. }
        if words.letters().any(|word| !b"XYZLW".contains(&word)))
}

/// Whether the printer is taken to have homed by itself when it has carried out a command that
/// prepares a print.
#[must_use]
pub fn homes_by_itself(command: &Command<'_>) -> bool {
    matches!(command, Command::Named(..) | Command::G(PRIMES, _))
}

/// What a command is called in a list: its code or name, without its words.
#[must_use]
pub fn name(command: &Command<'_>) -> String {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).to_uppercase();
    match *command {
        Command::G(code, _) => format!("G{code}"),
        Command::M(code, _) => format!("M{code}"),
        Command::Sub(letter, code, _) => format!("{}{}", char::from(letter), text(code)),
        Command::Named(name, _) => text(name),
        Command::Units { inches, .. } => if inches { "G20" } else { "G21" }.into(),
        Command::Positioning { relative, .. } => if relative { "G91" } else { "G90" }.into(),
        Command::Extrusion { relative, .. } => if relative { "M83" } else { "M82" }.into(),
        Command::ArcPlane(plane, _) => format!("G{}", 17 + plane as u8),
        Command::Dwell { .. } => "G4".into(),
        Command::Home { .. } => "G28".into(),
        Command::Tool(number, _) => format!("T{number}"),
        Command::Linear { .. }
        | Command::Arc { .. }
        | Command::SetPosition { .. }
        | Command::Comment(_)
        | Command::Garbage(_) => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::line::parse_line;

    fn effect_of(line: &str, dialect: Dialect) -> Effect {
        parse_line(line.as_bytes()).map_or(Effect::Harmless, |command| effect(&command, dialect))
    }

    #[test]
    fn heat_fans_messages_and_waits_are_harmless() {
        for line in [
            "M104 S210",
            "M109 R200",
            "M106 S255",
            "M117 G1 Z0 is only a text",
            "M400",
            "G10 P0 S210 R160",
            "M862.3 P \"MK4S M3\"",
            "SET_PIN PIN=air VALUE=1",
            "exclude_object_start NAME=a",
            "M486 S1",
            "M486 Aa cap.stl",
            "M209 S0",
            "M208 S0.2 F300",
            "G94",
            "%",
            "M118 A1 action:notification Layer 3",
            "RESPOND TYPE=command MSG=\"action:prompt_begin Pause\"",
        ] {
            assert_eq!(effect_of(line, Dialect::Marlin), Effect::Harmless, "{line}");
        }
    }

    #[test]
    fn what_prepares_a_print_is_told_from_what_never_is_judged() {
        for line in [
            "G29",
            "G80",
            "G280 S1",
            "M420 S1",
            "PRINT_START BED=60",
            "BED_MESH_CALIBRATE",
            "G29.1",
        ] {
            assert_eq!(effect_of(line, Dialect::Marlin), Effect::Prepares, "{line}");
        }
        for line in [
            "G5 X1 Y1 P1 Q1",
            "G10 L2 P1 Z5",
            "G54",
            "M206 Z-1",
            "M290 Z-1",
            "M600",
            "M851 Z2",
            "M209 S1",
            "M486 C",
            "EXCLUDE_OBJECT NAME=a",
            "SET_GCODE_OFFSET Z=-2",
            "RESTORE_GCODE_STATE NAME=a MOVE=1",
            "G92.1",
            "M569 P0 S0",
            "M5000",
            "M208 Z-5 S1",
            "M303 E0 S200",
            "M118 A1 P0 action:pause",
            "M118 //ACTION: cancel",
            "RESPOND TYPE=command MSG=\"action:pause\"",
        ] {
            assert!(matches!(effect_of(line, Dialect::Marlin), Effect::Unknown(_)), "{line}");
        }
    }

    #[test]
    fn a_second_command_in_a_line_is_seen_behind_any_that_has_words() {
        let has = |line: &str| parse_line(line.as_bytes()).is_some_and(|c| has_second_command(&c));
        for first in ["G90", "G21", "G18", "M82", "M83", "M104 S200", "G4 P1", "G28", "T0", "G10"] {
            assert!(has(&format!("{first} G1 Z0")), "{first}");
            assert!(!has(first), "{first}");
            assert!(!has(&format!("{first} ; G1 Z0")), "{first}");
        }
        assert!(!has("M117 G1 Z0") && !has("RESPOND MSG=G1"));
    }

    #[test]
    fn klipper_has_no_inches_and_no_volumes() {
        for line in ["G20", "M200 D1.75"] {
            assert!(matches!(effect_of(line, Dialect::Klipper), Effect::Unknown(_)), "{line}");
            assert_eq!(effect_of(line, Dialect::Marlin), Effect::Harmless, "{line}");
        }
    }

    #[test]
    fn every_list_is_in_order_and_no_code_stands_in_two() {
        let lists = [HARMLESS_M, PREPARES_M, FRAME_M];
        for list in [HARMLESS_M, PREPARES_M, FRAME_M, HARMLESS_G, PREPARES_G, FRAME_G, TEXT_M] {
            assert!(list.is_sorted(), "{list:?}");
        }
        for (i, list) in lists.iter().enumerate() {
            let others = || lists[..i].iter().copied().flatten();
            assert!(list.iter().all(|code| !others().any(|other| other == code)));
        }
        assert!(HARMLESS_NAMED.is_sorted() && FRAME_NAMED.is_sorted());
    }
}
