//! Mistakes in case files are told with line and key.

use fmc_benchmarks::case::Document;
use std::path::Path;

/// The sentences about a case file.
fn complaint(text: &str) -> String {
    match Document::parse("my", "my.toml", Path::new(""), text).and_then(|document| document.case()) {
        Ok(_) => panic!("nothing was found wrong"),
        Err(error) => error.to_string(),
    }
}

/// The bar's file with one passage replaced.
fn spoilt(passage: &str, by: &str) -> String {
    let text = include_str!("../../cases/bar.toml");
    assert!(text.contains(passage), "the bar's file has no '{passage}'");
    text.replacen(passage, by, 1)
}

/// Line of a passage in a text, from 1.
fn line_of(text: &str, passage: &str) -> usize {
    1 + text.lines().position(|line| line.contains(passage)).unwrap()
}

/// A curve that is compared has numbers: a run that met an infinite one never ended.
#[test]
fn curves_are_finite() {
    let text = include_str!("../../cases/wedge.toml").replacen("[0.01, 322]", "[0.01, inf]", 1);
    let complaint = complaint(&text);
    assert!(complaint.contains("figures.profile") && complaint.contains("finite"), "{complaint}");
}

#[test]
fn every_mistake_has_its_line_and_key() {
    // What stands in the file, what is put there, the key that is blamed, a word of the advice.
    let mistakes = [
        ("young = 900.0", "young = -900.0", "bodies.bar.material.young", "positive"),
        ("young = 900.0", "young = \"soft\"", "bodies.bar.material.young", "number"),
        ("young = 900.0", "yuong = 900.0", "bodies.bar.material.yuong", "did you mean 'young'"),
        ("poisson = 0.0", "poisson = 0.5", "bodies.bar.material.poisson", "below 0.5"),
        ("law = \"linear-elastic\"", "law = \"rubber\"", "bodies.bar.material", "neo-hookean"),
        ("initial_velocity = [0.0, -10.0]", "initial_velocity = [0.0]", "bodies.bar.initial_velocity", "2 numbers"),
        ("cells = [1, 100]", "cells = [0, 100]", "bodies.bar.mesh", "at least 1"),
        ("cell = \"quad4\"", "cell = \"hex8\"", "bodies.bar.mesh", "tri3 or quad4"),
        ("max = [5.0, 11.0]", "max = [5.0, 0.0]", "bodies.bar.mesh", "larger than min"),
        ("shape = \"rectangle\"", "shape = \"blob\"", "bodies.bar.mesh", "rectangle"),
        ("dimension = 2", "dimension = 4", "dimension", "2 or 3"),
        ("dimension = 2", "dimension = 3", "bodies.bar.mesh", "2D mesh in a 3D case"),
        ("components = [\"x\"]", "components = [\"z\"]", "supports.0.components", "\"x\" and \"y\""),
        ("where = { side = \"left\" }", "where = { side = \"lower\" }", "supports.0.where.side", "bottom"),
        ("where = { side = \"left\" }", "where = { axis = \"x\" }", "supports.0.where", "one of"),
        ("shape = \"half-space\"", "shape = \"ball\"", "obstacles.wall", "needs radius"),
        ("stiffness = 3600.0", "stiffness = 0.0", "contact.stiffness", "positive"),
        (
            "stiffness = 3600.0",
            "stiffness = 1.0\nfriction_coefficient = -0.1",
            "contact.friction_coefficient",
            "at least 0",
        ),
        ("stiffness = 3600.0", "stiffness = 1.0\nfriction_stiffness = 0.0", "contact.friction_stiffness", "positive"),
        ("stiffness = 3600.0", "stiffness = 1.0\ncohesion = -1.0", "contact.cohesion", "at least 0"),
        ("stiffness = 3600.0", "stiffness = 1.0\nshear_limit = 0.0", "contact.shear_limit", "positive"),
        ("law = \"fiber\"", "law = \"fibre\"", "contact.law", "fiber"),
        ("step = 1.6666666666666667e-3", "step = 1", "time.step", "at most end"),
        ("step = 1.6666666666666667e-3", "fraction = 1.5", "time.fraction", "at most 1"),
        ("end = 0.9", "end = 0.9\ncontact_substeps = 0", "time.contact_substeps", "1 to"),
        ("end = 0.9", "", "time", "end"),
        ("body = \"bar\"", "body = \"rod\"", "supports.0.body", "there are: bar"),
        ("value = 300.0", "value = inf", "expected.0.value", "finite"),
        ("figure = \"pressure_mean\"", "figure = \"pressure\"", "expected.0.figure", "pressure_mean"),
    ];
    for (passage, by, key, advice) in mistakes {
        let text = spoilt(passage, by);
        let complaint = complaint(&text);
        assert!(complaint.starts_with("my.toml:"), "{by}: {complaint}");
        assert!(complaint.contains(&format!(": {key}")), "{by}: {complaint}");
        assert!(complaint.contains(advice), "{by}: {complaint}");
        let line: usize = complaint["my.toml:".len()..].split(':').next().unwrap().parse().unwrap();
        // What is missing is blamed on what it is missing from, what is there on its own line.
        if !by.is_empty() && key != "obstacles.wall" && !by.starts_with("dimension = 3") {
            let blamed = by.lines().last().unwrap_or(by);
            assert_eq!(line, line_of(&text, blamed), "{by}: {complaint}");
        }
    }
}

#[test]
fn several_mistakes_are_told_at_once() {
    let text = spoilt("young = 900.0", "young = -1.0").replace("end = 0.9", "end = -1.0");
    let complaint = complaint(&text);
    assert!(complaint.contains("young") && complaint.contains("time.end"), "{complaint}");
}

#[test]
fn what_a_law_does_not_have_is_told() {
    let told = complaint(&spoilt("law = \"fiber\"", "law = \"volume\"\nfriction_coefficient = 0.3"));
    assert!(told.contains(": contact.friction_stiffness") && told.contains("of its own"), "{told}");
    let hertz = include_str!("../../cases/hertz.toml").replace("count = 1", "count = 1\npenetration = 1e-6");
    let told = complaint(&hertz.replace("law = \"fiber\"", "law = \"fiber\"\nfriction_coefficient = 0.3"));
    assert!(told.contains(": load_steps.penetration") && told.contains("friction"), "{told}");
    let hertz = hertz.replace("law = \"fiber\"", "law = \"volume\"");
    let told = complaint(&hertz);
    assert!(told.contains(": load_steps.penetration") && told.contains("laws \"fiber\" and \"depth\""), "{told}");
}

#[test]
fn what_is_no_toml_has_a_line() {
    let text = spoilt("end = 0.9", "end = = 0.9");
    let complaint = complaint(&text);
    assert!(complaint.starts_with(&format!("my.toml:{}: ", line_of(&text, "end = ="))), "{complaint}");
}

#[test]
fn overrides_are_blamed_for_what_they_do() {
    let complaint = |change: &str| {
        let mut document = Document::open("star").unwrap();
        match document.override_with("--override", change).and_then(|()| document.case()) {
            Ok(_) => panic!("'{change}' is accepted"),
            Err(error) => error.to_string(),
        }
    };
    let expected = [
        ("contact.exponnt=2", "did you mean 'exponent'"),
        ("contact.exponent=0.5", "at least 1"),
        ("contact.exponent=two", "number"),
        ("bodies.stra.material.young=1e6", "bodies has no 'stra'; it has star, block"),
        ("bodies.star.material.yuong=1e6", "did you mean 'young'"),
        ("tme.step=1e-6", "did you mean 'time'"),
        ("time.step", "KEY=VALUE"),
        ("bodies.star.mesh.tips=2", "at least 3"),
    ];
    for (change, advice) in expected {
        let complaint = complaint(change);
        assert!(complaint.starts_with(&format!("--override {change}: ")), "{complaint}");
        assert!(complaint.contains(advice), "{complaint}");
    }
}

#[test]
fn overrides_change_what_they_name() {
    let changes = [
        "bodies.star.material.young=1e6",
        "bodies.1.material.poisson=0.3",
        "time.step=1.9445e-6",
        "contact.estimator=fibers",
        "bodies.star.initial_velocity=[1, -2]",
        "bodies.star.initial_velocity.0=3",
        "contact.seed=7",
    ];
    let case = super::document("star", &changes).case().unwrap();
    assert_eq!((case.bodies[0].material.young, case.bodies[1].material.poisson), (1e6, 0.3));
    assert_eq!((case.time.step, case.contact.seed), (Some(1.9445e-6), 7));
    assert_eq!(case.contact.estimator_word(), "lines");
    assert_eq!(case.bodies[0].initial_velocity, Some(vec![3.0, -2.0]));
}

#[test]
fn unknown_cases_and_variants_are_told_what_there_is() {
    let error = Document::open("sta").unwrap_err().to_string();
    assert!(error.contains("did you mean 'star'"), "{error}");
    let error = Document::open("no/such.toml").unwrap_err().to_string();
    assert!(error.contains("cannot be read"), "{error}");
    let error = Document::open("bar").unwrap().choose("volum").unwrap_err().to_string();
    assert!(error.contains("volume-300"), "{error}");
}

/// Every built-in case holds with each of its variants, and generated and described meshes agree.
#[test]
fn built_in_cases_are_sound() {
    for (name, _) in fmc_benchmarks::case::library::CASES {
        let plain = Document::open(name).unwrap();
        let case = plain.case().unwrap_or_else(|error| panic!("{error}"));
        for variant in case.variants.keys() {
            let mut document = plain.clone();
            document.choose(variant).unwrap();
            document.case().unwrap_or_else(|error| panic!("{name}, {variant}: {error}"));
        }
        let written = toml::to_string(&case).unwrap();
        let again = Document::parse(name, "again.toml", Path::new(""), &written).unwrap().case();
        assert_eq!(again.unwrap_or_else(|error| panic!("{error}")), case, "{name}");
    }
}
