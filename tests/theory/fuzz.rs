//! Fuzzing: repeatable, resumable, and able to refute.

use std::fs;

use grazing::{
    existence::{Claim, Existence, Variant, by_definition, claimed},
    local::Ladder,
    search::{
        Instance,
        fuzz::{Campaign, FuzzOptions, FuzzTally, Tally, fuzz, refute},
    },
};

fn options() -> FuzzOptions {
    FuzzOptions { first: 1, last: 40, cases: 200_000, seed: 7, definition_share: 0.02 }
}

/// The tally without its times.
fn counts(tally: FuzzTally) -> FuzzTally {
    FuzzTally { sweep_seconds: 0.0, weighted_seconds: 0.0, ..tally }
}

#[test]
fn conjecture_1_withstands_a_short_run() {
    let options = FuzzOptions { cases: 5_000_000, ..options() };
    let tally = fuzz(&options, 0..options.units(), FuzzTally::default(), &(), |_| Ok(())).unwrap();
    assert_eq!(tally.disagreements, Vec::<String>::new());
    // Nor do two routes of this program to one answer differ, as they would if a sweep took another k.
    assert_eq!(tally.faults, Vec::<String>::new());
    assert_eq!(tally.undecided, 0);
    assert_eq!(tally.units, options.cases.div_ceil(options.block()));
    assert!(tally.decided() >= options.cases);
    assert!(tally.weighted > 500 && tally.repeated > 50 && tally.ball > 0 && tally.boundary > 0, "{tally:?}");
}

#[test]
fn threads_and_interruptions_change_nothing() {
    let whole = fuzz(&options(), 0..options().units(), FuzzTally::default(), &(), |_| Ok(())).unwrap();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut states = Vec::new();
    let longer = FuzzOptions { cases: 1_000_000, ..options() };
    let single = pool.install(|| {
        fuzz(&longer, 0..longer.units(), FuzzTally::default(), &(), |tally| {
            states.push(tally.clone());
            Ok(())
        })
    });
    let single = counts(single.unwrap());
    // From the end of a shorter run, and from every state of the longer one.
    for state in states.into_iter().chain([whole]) {
        let resumed = fuzz(&longer, 0..longer.units(), state, &(), |_| Ok(())).unwrap();
        assert_eq!(counts(resumed), single);
    }
}

/// A run is the blocks that reach the cases asked for, and what they have beside their sweeps.
#[test]
fn cases_are_what_was_asked_for_to_within_a_block() {
    for (first, last, cases) in [(1, 3, 1), (1, 64, 1), (1, 64, 100_000), (60, 64, 5_000), (12, 12, 10_000)] {
        let options = FuzzOptions { first, last, cases, ..options() };
        let tally = fuzz(&options, 0..options.units(), FuzzTally::default(), &(), |_| Ok(())).unwrap();
        let most = cases + options.block() + tally.repeated + tally.weighted;
        assert!((cases..most).contains(&tally.decided()), "{} for {options:?}", tally.decided());
    }
    let none = FuzzOptions { cases: 0, ..options() };
    assert!(fuzz(&none, 0..0, FuzzTally::default(), &(), |_| Ok(())).is_err());
}

/// What no run comes to is refused, also where a sum would wrap or a loop have no end.
#[test]
fn false_tallies_are_refused() {
    let good = fuzz(&options(), 0..options().units(), FuzzTally::default(), &(), |_| Ok(())).unwrap();
    options().check(&good).unwrap();
    let damages: [fn(&mut FuzzTally); 12] = [
        |tally| tally.units = u64::MAX,
        |tally| tally.units += 1,
        |tally| tally.swept = u64::MAX,
        |tally| tally.swept += 1,
        |tally| tally.boundary = u64::MAX - 5,
        |tally| tally.weighted = u64::MAX,
        |tally| tally.repeated += 1,
        |tally| tally.undecided += 1,
        |tally| tally.sweep_seconds = f64::NAN,
        |tally| tally.weighted_seconds = -1.0,
        |tally| tally.disagreements.push("3 polar 1/2 1/5".into()),
        |tally| tally.disagreements.push("nonsense".into()),
    ];
    for (index, damage) in damages.into_iter().enumerate() {
        let mut tally = good.clone();
        damage(&mut tally);
        assert!(
            fuzz(&options(), 0..options().units(), tally, &(), |_| Ok(())).unwrap_err().is_input(),
            "damage {index}"
        );
    }
}

/// The neighbours exchanged, or an end shifted: false, and found out.
#[test]
fn false_variants_are_refuted() {
    for variant in [Variant::NeighboursExchanged, Variant::EndsShifted] {
        let case = refute(variant, 1, 1_000_000, 64).expect("the variant is false");
        assert!(case.n <= 5 && case.to_string().len() < 30, "shrunk to a small case: {case}");
        let ladder = Ladder::default();
        let found = by_definition(&ladder, &case.point, case.n);
        let says = |variant| match claimed(&ladder, &case.point, case.n, variant) {
            Claim::Orbit(case) => vec![case],
            Claim::None => Vec::new(),
            other => panic!("{other:?}"),
        };
        assert_ne!(says(variant), found.cases(case.n));
        assert_eq!(says(Variant::True), found.cases(case.n));
    }
}

#[test]
fn the_truth_is_not_refuted() {
    assert!(refute(Variant::True, 1, 2_000, 64).is_none());
}

#[test]
fn earlier_findings_are_decided_again() {
    let text =
        fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/fuzz_regressions.txt"))
            .unwrap();
    let ladder = Ladder::default();
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
    assert!(lines.len() >= 3);
    for line in lines {
        let case: Instance = line.parse().unwrap();
        assert_eq!(case.to_string(), line);
        let claim = match claimed(&ladder, &case.point, case.n, Variant::True) {
            Claim::Orbit(found) => Existence::Orbit(found).cases(case.n),
            _ => Vec::new(),
        };
        assert_eq!(by_definition(&ladder, &case.point, case.n).cases(case.n), claim, "{line}");
    }
}

#[test]
fn cases_that_are_no_cases_say_so() {
    for line in ["", "3 polar 1/2", "0 polar 1/2 1/4", "x plane 1 1", "3 disc 1/2 1/4", "3 polar 1/2 3/4"] {
        assert!(line.parse::<Instance>().unwrap_err().is_input(), "{line}");
    }
}

mod words {
    //! The same for `fuzz --words`.

    use grazing::{
        existence::by_definition,
        local::Ladder,
        search::fuzz::{
            Campaign, Tally, fuzz,
            words::{WordOptions, WordStatement, WordTally, refute_words, replayed},
        },
        word::Word,
    };

    fn options() -> WordOptions {
        WordOptions { last: 64, cases: 60_000, seed: 7, definition_share: 2e-4 }
    }

    fn counts(tally: WordTally) -> WordTally {
        WordTally { sweep_seconds: 0.0, other_seconds: 0.0, ..tally }
    }

    fn run(options: &WordOptions, from: WordTally) -> WordTally {
        fuzz(options, 0..options.units(), from, &(), |_| Ok(())).unwrap()
    }

    #[test]
    fn the_word_theorem_withstands_a_short_run_and_goes_on_where_it_ended() {
        let short = run(&WordOptions { cases: 1, ..options() }, WordTally::default());
        assert_eq!(short.units, 1);
        let tally = run(&options(), short);
        assert_eq!(tally.disagreements, Vec::<String>::new());
        assert_eq!(tally.faults, Vec::<String>::new());
        assert_eq!((tally.undecided, tally.beyond.len()), (0, 0));
        assert_eq!(tally.units, options().cases.div_ceil(options().block()));
        assert!(tally.decided() >= options().cases);
        assert!(
            tally.exact > 10 && tally.repeated > 5 && tally.words > 2 && tally.pairs > tally.swept,
            "{tally:?}"
        );
        assert_eq!(counts(run(&options(), WordTally::default())), counts(tally));
    }

    /// What no run comes to is refused.
    #[test]
    fn false_tallies_are_refused() {
        let good = run(&WordOptions { cases: 1, ..options() }, WordTally::default());
        options().check(&good).unwrap();
        let damages: [fn(&mut WordTally); 9] = [
            |tally| tally.units = u64::MAX,
            |tally| tally.units += 1,
            |tally| tally.swept += 1,
            |tally| tally.boundary = u64::MAX - 5,
            |tally| tally.weighted = u64::MAX,
            |tally| tally.largest[0] = f64::NAN,
            |tally| tally.sweep_seconds = -1.0,
            |tally| tally.disagreements.push("words 5 polar 1/2 1/5".into()),
            |tally| tally.disagreements.push("5 polar 1/2 1/5".into()),
        ];
        for (index, damage) in damages.into_iter().enumerate() {
            let mut tally = good.clone();
            damage(&mut tally);
            assert!(
                fuzz(&options(), 0..options().units(), tally, &(), |_| Ok(())).unwrap_err().is_input(),
                "damage {index}"
            );
        }
        for options in [
            WordOptions { cases: 0, ..options() },
            WordOptions { last: 2, ..options() },
            WordOptions { last: 1025, ..options() },
        ] {
            assert!(
                fuzz(&options, 0..options.units(), WordTally::default(), &(), |_| Ok(()))
                    .unwrap_err()
                    .is_input()
            );
        }
    }

    /// Each false statement is refuted, and shrunk to a point at which the definition and the word agree.
    #[test]
    fn false_statements_are_refuted() {
        for statement in
            [WordStatement::NothingPassedOver, WordStatement::EarlierDecides, WordStatement::LastPairBoth]
        {
            let case = refute_words(statement, 1, 100_000).expect("the statement is false");
            assert!(case.n <= 24 && case.to_string().len() < 30, "{statement:?} shrunk to {case}");
            let ladder = Ladder::default();
            let word = Word::at(&ladder, &case.point, true, 50, &()).unwrap();
            let occurs =
                |n| by_definition(&ladder, &case.point, n).cases(n).iter().any(|case| case.sign_emu() > 0);
            let found: Vec<u64> = (1..=case.n).filter(|&n| occurs(n)).collect();
            let listed: Vec<u64> = word.up_to(case.n).iter().map(|vertex| vertex.period).collect();
            assert_eq!(found, listed, "{case}");
        }
        assert!(refute_words(WordStatement::True, 1, 100).is_none());
        assert!(replayed("words 5 polar 1/2 1/5").is_ok() && replayed("5 polar 1/2 1/5").is_err());
    }
}
