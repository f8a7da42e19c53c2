//! The language as POV-Ray 3.7.0.10 was measured to read it.
//!
//! Each test names the section of the language facts whose probes it holds.

use super::{Evaluator, Limits, Memory, NoQueries, Number, Options, Value, evaluate};
use crate::diag::Severity;

/// The error of reading a text, if there is one, and what it printed.
fn read(files: &[(&str, &str)]) -> (Option<String>, String, Vec<String>) {
    let host = Memory::new(files.iter().copied());
    // Endless loops are among the tests.
    let limits = Limits { steps: 100_000, ..Limits::strict() };
    let options = Options { limits, ..Options::default() };
    let result = evaluate("main.pov".as_ref(), &options, &host, &NoQueries);
    let (error, diagnostics) = match result {
        Ok(read) => (None, read.warnings),
        Err(failed) => {
            let first = failed.diagnostics.iter().find(|d| d.severity == Severity::Error);
            (first.map(|d| d.message.clone()), failed.diagnostics)
        }
    };
    (error, host.messages(), diagnostics.into_iter().map(|d| d.message).collect())
}

/// A scene prints this with `#debug`, and is read without error.
fn prints(text: &str, expected: &str) {
    let (error, printed, _) = read(&[("main.pov", &format!("#version 3.7;\n{PRELUDE}{text}"))]);
    assert_eq!((error, &*printed), (None, expected), "{text}");
}

/// A scene with include files prints this.
fn prints_with(files: &[(&str, &str)], expected: &str) {
    let (error, printed, _) = read(files);
    assert_eq!((error, &*printed), (None, expected), "{files:?}");
}

/// A scene cannot be read, and the message says this.
fn fails(text: &str, message: &str) {
    let (error, _, _) = read(&[("main.pov", &format!("#version 3.7;\n{PRELUDE}{text}"))]);
    assert!(error.as_ref().is_some_and(|e| e.contains(message)), "{text}\n{error:?}");
}

/// A scene is read with a warning that says this.
fn warns(text: &str, message: &str) {
    let (error, _, warnings) = read(&[("main.pov", &format!("#version 3.7;\n{text}"))]);
    assert!(error.is_none() && warnings.iter().any(|w| w.contains(message)), "{text}\n{error:?} {warnings:?}");
}

/// `F(e)` prints a float or string; `P(v)` a vector.
const PRELUDE: &str = "#macro F(e) #debug concat(str(e,0,6), \" \") #end #macro S(e) #debug concat(e, \" \") #end\n";

/// The value of a declaration `#declare R = expression;`, by its numbers.
fn declared(expression: &str) -> Result<Value, String> {
    let text = format!("#version 3.7;\n#declare R = {expression};");
    let (host, options) = (Memory::new([("main.pov", text.as_str())]), Options::default());
    let mut evaluator = Evaluator::new(&options, &host, &NoQueries);
    evaluator.read_scene("main.pov".as_ref(), text.into_bytes()).map_err(|e| e[0].message.clone())?;
    let name = evaluator.names.words.intern("R");
    evaluator.names.find(name).and_then(super::Place::get).ok_or_else(|| "nothing".to_owned())
}

/// A declared expression has these components, to the digits that were measured.
fn check(expression: &str, expected: &[f64]) {
    /// Probes were printed with 15 significant digits at best.
    const DIGITS: f64 = 1e-14;
    match declared(expression).map(|v| v.number()) {
        Ok(Some(Number { n, v })) => {
            let same =
                |a: f64, b: f64| a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= DIGITS * b.abs().max(1.0);
            let all = v[..n as usize].iter().zip(expected).all(|(a, b)| same(*a, *b));
            assert!(n as usize == expected.len() && all, "{expression}: {:?}, expected {expected:?}", &v[..n as usize]);
        }
        other => panic!("{expression}: {other:?}"),
    }
}

/// A declared expression is refused.
fn refused(expression: &str, message: &str) {
    let error = declared(expression).err();
    assert!(error.as_ref().is_some_and(|e| e.contains(message)), "{expression}: {error:?}");
}

/// A declared expression is this string.
fn string(expression: &str, expected: &str) {
    match declared(expression) {
        Ok(Value::String(text)) => assert_eq!(&*text, expected, "{expression}"),
        other => panic!("{expression}: {other:?}"),
    }
}

/// Language facts, section 1.
#[test]
fn lexical_rules() {
    check("/* a /* b */ c */ 1", &[1.0]);
    check("1e", &[1.0]);
    check(".5", &[0.5]);
    check("5.", &[5.0]);
    check("007", &[7.0]);
    check("1.e1", &[10.0]);
    check("1e400", &[f64::INFINITY]);
    refused("1.2.3", "decimal point");
    refused("\"never closed", "never closed");
    string(r#""a\nb\tc\\d\"e\u0041\'""#, "a\nb\tc\\d\"eA'");
    refused(r#""a\qb""#, "unknown escape");
    string(&format!("\"{}\"", "a".repeat(255)), &"a".repeat(255));
    refused(&format!("\"{}\"", "a".repeat(256)), "255");
    string("\"\u{e9}\"", "  ");
    check(r#"asc("\u20AC")"#, &[8364.0]);
    prints("# /* x */ declare A = 1; F(A)", "1.000000 ");
    prints("#if (0) \"a\\qb\" it's @ \\ $ ^ % ~ ` #end F(1)", "1.000000 ");
    fails("#if (0) \" #end F(1)", "never closed");
}

/// Language facts, section 1.
#[test]
fn byte_order_mark_switches_to_utf8() {
    let text = "\u{feff}#version 3.7; #debug str(asc(\"\u{e9}\"),0,0) #debug str(strlen(\"\u{e9}\u{20ac}\"),0,0)";
    prints_with(&[("main.pov", text)], "2332");
}

/// Language facts, section 2.
#[test]
fn reserved_words_cannot_be_declared() {
    for keyword in crate::syntax::Keyword::ALL {
        let word = keyword.word();
        if *keyword != crate::syntax::Keyword::Deprecated {
            fails(&format!("#declare {word} = 1;"), "reserved word");
        }
    }
    prints("F(defined(sphere)) F(defined(image_width)) F(image_width)", "0.000000 1.000000 320.000000 ");
    refused("1*sqr(3)", "expected a number");
}

/// Language facts, section 3.
#[test]
fn separators() {
    check("pow(2 3)", &[8.0]);
    refused("max(1 2)", "')'");
    check("select(1 2 3)", &[3.0]);
    check("<1,2 -3>", &[1.0, -1.0]);
    fails("#declare A=1", "';'");
    prints("#declare A=1;; F(A)", "1.000000 ");
    fails("#undef A;", "';'");
    fails("#if (1,2) #end", "','");
    prints("declare A = 2; F(A)", "2.000000 ");
}

/// Language facts, section 4.
#[test]
fn stored_colors_are_single_precision() {
    prints("#declare V=<.1,.2,.3,.4,.5>; #debug str(V.x,0,15)", "0.100000001490116");
    prints("#debug str(<.1,.2,.3,.4,.5>.x,0,15)", "0.100000000000000");
    prints("#declare C=rgb<.1,.2,.3>; #debug str((C*2).green,0,15)", "0.400000005960464");
}

/// Language facts, section 5.
#[test]
fn operators() {
    check("2--3", &[5.0]);
    check("--3", &[3.0]);
    check("!1+1", &[1.0]);
    check("!0*5", &[5.0]);
    check("(3>2>1)", &[0.0]);
    check("(0&0|1)", &[1.0]);
    check("(1|0&0)", &[0.0]);
    check("(1=1=1)", &[1.0]);
    check("(1e-10=0)", &[1.0]);
    check("(1.1e-10=0)", &[0.0]);
    check("(1<=1-1e-11)", &[1.0]);
    check("(1>1-1e-11)", &[1.0]);
    check("(1!=1+1e-11)", &[0.0]);
    check("(\"B\"<\"a\")", &[1.0]);
    check("(\"ab\"=concat(\"a\",\"b\"))", &[1.0]);
    check("-1/0", &[f64::INFINITY]);
    check("0/0", &[f64::INFINITY]);
    check("1e308*10", &[f64::INFINITY]);
    check("(1e308*10=1e308*20)", &[1.0]);
    check("(1 ? 2 : 3)", &[2.0]);
    check("(0 ? 2 : 0 ? 3 : 4)", &[4.0]);
    check("-<1,2,3>.y", &[-2.0]);
    check("!<0,1,1e-11>", &[1.0, 0.0, 1.0]);
    check("2*3+4*5-6/2", &[23.0]);
    check("8/4/2", &[1.0]);
    refused("1>0", "';'");
    refused("1?2:3", "';'");
    prints("#declare R=seed(1); #declare A=(1?5:rand(R)); #debug str(rand(R),0,15)", "0.487121198206935");
}

/// Language facts, section 5.
#[test]
fn widths() {
    check("5+x", &[6.0, 5.0, 5.0]);
    check("<1,2>+<1,1,1>", &[2.0, 3.0, 1.0]);
    check("<1,2>*<1,2,3>", &[1.0, 4.0, 0.0]);
    check("<1 -1 2>", &[0.0, 2.0]);
    check("<1 2 3>", &[1.0, 2.0, 3.0]);
    check("<1,2,3,>", &[1.0, 2.0, 3.0]);
    check("(1?1:<1,2,3>)", &[1.0]);
    check("5+u", &[6.0, 5.0]);
    check("1*t", &[0.0, 0.0, 0.0, 1.0]);
    check("<1,2,3,4,5>.transmit", &[5.0]);
    check("<.25,.5,1>.gray", &[0.297 * 0.25 + 0.589 * 0.5 + 0.114]);
    check("x + <1,2>", &[2.0, 2.0, 0.0]);
    refused("<1>", "two to five");
    refused("<1,2,3,4,5,6>", "'>'");
    refused("<x,1,2>", "expected a float");
    refused("<1,2,3>.t", "no component");
    refused("sin(x)", "expected a float");
    check("vlength(5)", &[75.0_f64.sqrt()]);
    prints("#declare T = transform { translate 5+u } F(1)", "1.000000 ");
}

/// Language facts, section 6.
#[test]
fn colors() {
    check("rgbt <1,2,3,4>", &[1.0, 2.0, 3.0, 0.0, 4.0]);
    check("rgbf .5", &[0.5, 0.5, 0.5, 0.5, 0.0]);
    check("rgbft .5", &[0.5; 5]);
    check("color rgb <1,2,3> filter .5 transmit .25", &[1.0, 2.0, 3.0, 0.5, 0.25]);
    check("colour red 1 red 2", &[2.0, 0.0, 0.0, 0.0, 0.0]);
    check("color", &[0.0; 5]);
    check("color <1,.5,0>", &[1.0, 0.5, 0.0, 0.0, 0.0]);
    check("color .5", &[0.5; 5]);
    check("rgb <1,2,3,4>", &[1.0, 2.0, 3.0, 4.0, 0.0]);
    check("rgb (0?0.5:<0,1,0>)", &[0.0, 1.0, 0.0, 0.0, 0.0]);
    check("rgb 2*<1,2,3>", &[2.0, 4.0, 6.0, 0.0, 0.0]);
    refused("srgb 1", "gamma");
    prints("#declare C = rgb 1; #declare D = C filter .5; #debug str(D.filter,0,2)", "0.50");
}

/// Language facts, section 7.
#[test]
fn float_functions() {
    check("int(-1.7)", &[-1.0]);
    check("int(3e9)", &[-2_147_483_648.0]);
    check("mod(-7,3)", &[-1.0]);
    check("mod(7,-3)", &[1.0]);
    check("mod(-7.5,3)", &[-1.5]);
    check("mod(1,.1)", &[0.1]);
    check("mod(1,0)", &[f64::NAN]);
    check("div(-7,2)", &[-3.0]);
    check("div(1,0)", &[-2_147_483_648.0]);
    check("bitwise_and(-1,255)", &[255.0]);
    check("bitwise_or(1,2,4)", &[7.0]);
    check("bitwise_xor(3,1)", &[2.0]);
    check("select(1e-12,1,2,3)", &[3.0]);
    check("select(-1,1,2,3)", &[1.0]);
    check("select(0,1,2,3)", &[2.0]);
    check("max(1,5,3)", &[5.0]);
    check("min(1,5,-3)", &[-3.0]);
    check("acos(2)", &[0.0]);
    check("asin(-2)", &[-std::f64::consts::FRAC_PI_2]);
    check("degrees(pi)", &[180.0]);
    check("radians(180)", &[std::f64::consts::PI]);
    check("pow(-8,1/3)", &[f64::NAN]);
    check("pow(0,-1)", &[f64::INFINITY]);
    check("sqrt(2)", &[std::f64::consts::SQRT_2]);
    check("log(1000)", &[3.0]);
    check("ceil(-1.5) + floor(-1.5)", &[-3.0]);
    check("true + yes + on - false - no - off", &[3.0]);
    check("version", &[3.7]);
    check("clock + clock_on", &[0.0]);
    check("sin(1>0)", &[1.0_f64.sin()]);
    refused("pow(0,0)", "pow(0, 0)");
    refused("atan2(0,1e-11)", "atan2");
    refused("ln(0)", "not positive");
    refused("sqrt(-1)", "negative");
    refused("rand(0)", "no such random stream");
    refused("pow(1>0,1)", "'>'");
}

/// Language facts, section 7.
#[test]
fn random_streams() {
    prints("#declare R=seed(1); #debug str(rand(R),0,15)", "0.421992875268215");
    prints("#declare R=seed(1); #declare A=rand(R); #debug str(rand(R),0,15)", "0.487121198206935");
    prints("#declare R=seed(0); #debug str(rand(R),0,13) #debug str(rand(R),0,12)", "0.00000287429430.466563684509");
    prints(
        "#declare R=seed(123); #debug str(rand(R),0,9) #debug str(rand(R),0,9) #debug str(rand(R),0,9)",
        "0.9047729820.9951378690.518666593",
    );
    prints("#declare R=seed(-1); #debug str(rand(R),0,9)", "0.578012874");
    prints("#declare R=seed(5); #declare Q=seed(6); #declare T=R; F(Q) F(T)", "1.000000 0.000000 ");
}

/// Language facts, section 7.
#[test]
fn vector_functions() {
    check("vdot(<1,2,3>,<4,5,6>)", &[32.0]);
    check("vcross(x,y)", &[0.0, 0.0, 1.0]);
    check("vnormalize(<0,3,4>)", &[0.0, 0.6, 0.8]);
    check("vnormalize(0)", &[0.0; 3]);
    check("vrotate(<1,2,3>,<30,40,50>)", &[1.801281061919234, 2.507690147191264, 2.113498677939254]);
    check("vrotate(x,90*y)", &[0.0, 0.0, -1.0]);
    check("vaxis_rotate(<1,2,3>,<1,1,0>,90)", &[3.621320343559642, -0.621320343559643, 0.5_f64.sqrt()]);
    warns("#declare A = vnormalize(0);", "length zero");
    let six = |octaves: &str| format!("vstr(3,vturbulence(2,.5,{octaves},<1.1,2.2,3.3>),\" \",0,6)");
    string(&six("6"), "-0.492049 -0.251254 0.422431");
    string(&six("1"), "-0.387279 -0.145373 0.409631");
}

/// Language facts, section 7.
#[test]
fn string_functions() {
    string("str(-3.14159,-8,2)", "-0003.14");
    string("str(2.5,0,0)", "2");
    string("str(1e251,0,2)", "1e+251");
    string("vstr(3,5,\",\",0,2)", "5.00,0.00,0.00");
    string("vstr(9,<1,2,3,4,5>,\"-\",4,1)", " 1.0- 2.0- 3.0- 4.0- 5.0");
    string("concat(\"a\",\"b\" \"c\")", "abc");
    string("substr(\"abcdef\",2,3)", "bcd");
    string("chr(65)", "A");
    string("chr(0)", "");
    string("strupr(\"aBc\")", "ABC");
    string("strlwr(\"aBc\")", "abc");
    string("datetime(0)", "2000-01-01 00:00:00Z");
    check("strcmp(\"abc\",\"ab\")", &[99.0]);
    check("strcmp(\"a\",\"a\")", &[0.0]);
    check("strlen(\"abc\")", &[3.0]);
    check("asc(\"\")", &[0.0]);
    check("val(\"1e3x\")", &[1000.0]);
    check("val(\"0x10\")", &[16.0]);
    check("val(\"x\")", &[0.0]);
    check("file_exists(\"nowhere\")", &[0.0]);
    check("file_exists(\"main.pov\")", &[1.0]);
    refused("substr(\"abc\",2,3)", "outside");
    refused("chr(65536)", "65535");
}

/// Language facts, section 8.
#[test]
fn scopes() {
    prints(
        "#macro Inner() #declare X=5; #end #macro Outer() #local X=1; Inner() F(X) #end Outer() F(defined(X))",
        "5.000000 0.000000 ",
    );
    prints("#declare I=0; #while (I<1) #local Y=3; #declare I=I+1; #end F(Y)", "3.000000 ");
    prints_with(
        &[
            ("main.pov", "#version 3.7; #include \"a.inc\" #debug str(G,0,0) #debug str(defined(L),0,0)"),
            ("a.inc", "#declare G=1; #local L=2; #macro UsesL() L #end #debug str(UsesL(),0,0)"),
        ],
        "210",
    );
    prints("#declare A=1; #macro M() #local A=2; #declare A=3; F(A) #end M() F(A)", "3.000000 1.000000 ");
    prints("#declare A=1; #undef A F(defined(A))", "0.000000 ");
    prints("#declare A=1; #declare A=A+1; F(A)", "2.000000 ");
    prints("#declare A=1; #declare A=\"text\"; S(A)", "text ");
    warns("#undef Nothing", "not declared");
    warns("#declare deprecated once \"old\" A=1; #declare B=A;", "old");
    fails("#declare B=A;", "'A' is not declared");
    fails("#declare Chrom=1; #declare B=Chrome;", "'Chrome' is not declared");
}

/// Language facts, section 9.
#[test]
fn conditions() {
    prints("#if (1) S(\"a\") #else S(\"b\") #end", "a ");
    prints("#if (0) S(\"a\") #elseif (1) S(\"b\") #else S(\"c\") #end", "b ");
    prints("#if (0) S(\"a\") #elseif (0) S(\"b\") #else S(\"c\") #end", "c ");
    prints("#if (1) S(\"a\") #elseif (1/\"x\") S(\"b\") #else S(\"c\") #end", "a ");
    prints("#ifdef (Q) S(\"a\") #else S(\"b\") #end #ifndef (Q) S(\"c\") #end", "b c ");
    prints("#declare A=array[2]{1,2}; #undef A[0] F(defined(A[0])) #ifdef (A[1]) S(\"y\") #end", "0.000000 y ");
    prints("#if (0) #if (1) #else #end #while (1) #end #macro M() #end { ( #else S(\"x\") #end", "x ");
    fails("#else", "#else without");
    fails("#end", "#end without");
    fails("#if (1)", "before the #end");
    fails("#if (0)", "no #end");
    fails("#if (0) #else #else #end", "already had");
    fails("#if (1e999 - 1e999 = \"a\") #end", "expected a number");
}

/// Language facts, section 9.
#[test]
fn switches() {
    let cases = |value: &str, third: &str, end: &str| {
        format!("#switch({value}) #case(1) S(\"A\") #case(2) S(\"B\") {third} {end} #else S(\"D\") #end")
    };
    prints(&cases("2", "#case(3) S(\"C\")", "#break"), "B C ");
    prints(&cases("2", "", ""), "B D ");
    prints(&cases("7", "", ""), "D ");
    prints("#switch(1+1e-11) #case(1) S(\"A\") #end", "A ");
    prints("#switch(2.5+1e-11) #range(2,2.5) S(\"A\") #else S(\"B\") #end", "B ");
    prints("#switch(2.5) #range(2,2.5) S(\"A\") #break #case(9) S(\"B\") #end S(\"C\")", "A C ");
    prints("#switch(1) #declare Q=1; #case(1) S(\"A\") #end", "A ");
    fails("#switch(1) #else S(\"A\") #end", "at least one");
    fails("#switch(1) 5 #case(1) #end", "expected #case");
}

/// Language facts, section 9.
#[test]
fn loops() {
    prints("#for(I,0,1,.1) S(\"x\") #end F(I)", "x x x x x x x x x x x 1.100000 ");
    prints("#for(I,3,1) S(\"x\") #end F(I)", "3.000000 ");
    prints("#for(I,0,5) F(I) #declare I=I+1; #end", "0.000000 2.000000 4.000000 ");
    prints("#for(I,3,1,-1) F(I) #end", "3.000000 2.000000 1.000000 ");
    prints("#declare I=0; #while(I<3) F(I) #declare I=I+1; #end F(I)", "0.000000 1.000000 2.000000 3.000000 ");
    prints("#for(I,1,9) #if (I=3) #break #end F(I) #end S(\"end\")", "1.000000 2.000000 end ");
    prints("#macro M() S(\"a\") #break S(\"b\") #end #for(I,1,2) M() #end", "a a ");
    prints("#for(I,1,2) #for(J,1,2) #if (J=2) #break #end F(I*10+J) #end #end", "11.000000 21.000000 ");
    fails("#for(I,1,2,0) #end", "step");
    fails("#for(I,1,2) #declare I=\"a\"; #end", "another type");
    fails("#break", "#break outside");
    fails("#while (1) #end", "turns of loops");
}

/// Language facts, section 10.
#[test]
fn macros() {
    prints("#macro M(a) a* #end F(M(4) 5)", "20.000000 ");
    prints("#macro C(n) n<2 #end #if (C(1)&1) S(\"y\") #else S(\"n\") #end", "y ");
    prints("#macro A2() 1,2 #end #macro T(a,b) F(a) F(b) #end T(A2())", "1.000000 2.000000 ");
    prints("#macro L() < #end #macro R() > #end #declare V = (L() 1,2,3 R()); F(V.z)", "3.000000 ");
    prints("#macro Down(n) #if (n>0) F(n) Down(n-1) #end #end Down(3)", "3.000000 2.000000 1.000000 ");
    prints("#macro Fact(n) #if (n<2) 1 #else (n*Fact(n-1)) #end #end F((Fact(5)))", "120.000000 ");
    prints("#macro M() #declare A=5 #end M(); F(A)", "5.000000 ");
    prints("#macro M(a b) F(a) F(b) #end M(1 2)", "1.000000 2.000000 ");
    prints("#macro Outer() #macro Inner() S(\"i\") #end #end Outer() Inner()", "i ");
    prints("#macro M() S(\"1\") #end #macro M() S(\"2\") #end M()", "2 ");
    prints("#macro Q() 7; #end #declare N = Q() F(N)", "7.000000 ");
    fails("#macro M(a) #end M()", "takes 1 argument, not 0");
    fails("#macro M(a) #end M(1,2)", "expected ')'");
    fails("#macro M() M() #end M()", "macro calls inside one another");
    fails("#macro M() #if (1) #end M()", "no #end");
    fails("#macro M(a) #end M(Q)", "'Q' is not declared");
}

/// Language facts, section 10.
#[test]
fn arguments_by_reference_and_by_value() {
    let calls = |call: &str| format!("#macro M(a) #declare a=10; #end #declare Q=1; {call} F(Q)");
    prints(&calls("M(Q)"), "10.000000 ");
    prints(&calls("M((Q))"), "1.000000 ");
    prints(&calls("M(+Q)"), "1.000000 ");
    prints(&calls("M(Q+0)"), "1.000000 ");
    prints("#macro M(a) #local a=10; #end #declare Q=1; M(Q) F(Q)", "10.000000 ");
    prints("#macro M(a) #declare a=10; #end #declare A=array[2]{1,2}; M(A[1]) F(A[1])", "10.000000 ");
    prints("#macro M(a) #declare a=10; #end #declare V=<1,2,3>; M(V.x) F(V.x)", "1.000000 ");
    prints("#macro M(a) #declare a=\"s\"; #end #declare Q=1; M(Q) S(Q)", "s ");
    prints("#macro M(A) #declare A[0]=7; #end #declare Q=array[1]{1}; M(Q) F(Q[0])", "7.000000 ");
}

/// Language facts, section 11.
#[test]
fn arrays() {
    prints("#declare A=array[2.9]; F(dimension_size(A,1))", "2.000000 ");
    prints("#declare A=array[2]{5,6}; F(A[1.9]) F(A[.99999999999])", "6.000000 6.000000 ");
    prints("#declare A=array[2][2]{{1 2}{3 4}}; F(A[1][0]) F(dimensions(A))", "3.000000 2.000000 ");
    prints("#declare A=array[2]{array[1]{7},array[1]{8},} F(A[1][0])", "8.000000 ");
    prints("#declare A=array[1]{1}; #declare B=A; #declare B[0]=2; F(A[0]) F(B[0])", "1.000000 2.000000 ");
    prints("#declare A=array[2]; #declare A[0]=x; #declare A[1]=A[0]*2; F(A[1].x)", "2.000000 ");
    prints("#macro M(a) a #end #declare A=array[1]{1*M(3)}; F(A[0])", "3.000000 ");
    prints("#declare A=array[2]{<1,2,3>,<4,5,6>}; F(A[1].y) F(dimension_size(A,5))", "5.000000 0.000000 ");
    fails("#declare A=array[2]{1,\"2\"};", "type");
    fails("#declare A=array[2]; #declare A[0]=1; #declare A[1]=x;", "type");
    fails("#declare A=array[2]; F(A[0])", "never set");
    fails("#declare A=array[2]{1,2}; F(A[2])", "outside");
    fails("#declare A=array[2]{1,2}; F(A[-1])", "outside");
    fails("#declare A=array[2]{1,2,3};", "'}'");
    fails("#declare A=array[2][2]; #declare A[0]=1;", "'['");
    fails("#declare A=array[0];", "size");
    fails("#declare A=array[1e9][1e9];", "more than");
    fails("#macro M(a) a #end #declare A=array[2]{M(1),M(2)};", "macro call");
    warns("#declare A=array[1]{1}; #macro M() #local A[0]=2; #end M()", "nothing is stored");
}

/// Language facts, section 12.
#[test]
fn includes() {
    prints_with(
        &[("main.pov", "#version 3.7; #declare A = (1+#include \"f.inc\"); #debug str(A,0,0)"), ("f.inc", "3")],
        "4",
    );
    prints_with(&[("main.pov", "#version 3.7; #include concat(\"f\",\".inc\")"), ("f.inc", "#debug \"in\"")], "in");
    prints_with(
        &[("main.pov", "#version 3.7; #include \"f\""), ("f", "#debug \"x\""), ("f.inc", "#debug \"inc\"")],
        "inc",
    );
    prints_with(
        &[
            ("main.pov", "#version 3.7; #include \"a.inc\" #debug \"c\" #end"),
            ("a.inc", "#if (0) #debug \"a\" #else #debug \"b\""),
        ],
        "bc",
    );
    fails("#include \"nowhere.inc\"", "cannot find");
    let (error, ..) = read(&[("main.pov", "#include \"main.pov\"")]);
    assert!(error.is_some_and(|e| e.contains("include files inside one another")));
}

/// Language facts, section 12.
#[test]
fn file_output() {
    let text = "#version 3.7; #fopen W \"out\" write #write(W,1,2.5,1/3,123456789,1e-7,-0) #write(W,\"|\",x,\"\\n\") \
        #fclose W #fopen B \"bin\" write #write(B,sint8 200 (-200) 3.5 (-3.5), uint8 300, 2 300 -5) #fclose B \
        #fopen A \"out\" append #write(A, sint16be 258, sint32le 1) #debug str(defined(W),0,0)";
    let host = Memory::new([("main.pov", text)]);
    let read = evaluate("main.pov".as_ref(), &Options::default(), &host, &NoQueries);
    assert!(read.is_ok(), "{read:?}");
    let expected: &[u8] = b"12.50.3333331.23457e+081e-07-0|<1,0,0> \n\x01\x02\x01\x00\x00\x00";
    assert_eq!(host.file("out").as_deref(), Some(expected));
    assert_eq!(host.file("bin").as_deref(), Some(&b"\x7f\x80\x04\xfd\xff2295"[..]));
}

/// Language facts, section 12.
#[test]
fn file_input() {
    let reads = |data: &str, expected: &str| {
        let text =
            "#version 3.7; #fopen R \"data\" read #while (defined(R)) #read(R,A) #debug concat(str(A,0,0),\".\") #end";
        prints_with(&[("main.pov", text), ("data", data)], expected);
    };
    reads("1,2,3", "1.2.3.");
    reads("1,2,3,\n", "1.2.3.3.");
    // The sign behind 1 and the 3 are eaten, and a last turn reads nothing.
    reads("1\n-2\n3", "1.2.2.");
    reads("1 2 3", "1.3.");
    prints_with(
        &[
            (
                "main.pov",
                "#version 3.7; #fopen R \"d\" read #read(R,A,B,C) #debug concat(str(A,0,0),B,str(C.y,0,1)) #fclose R",
            ),
            ("d", "-5, \"b\", <1,-2.5,3>, 7"),
        ],
        "-5b-2.5",
    );
}

/// Language facts, section 13.
#[test]
fn messages() {
    prints("#debug \"a\" #debug \"b\\nc\" #debug \"\\n\"", "ab\nc\n");
    fails("#debug 5", "expected a string");
    fails("#error \"stop\"", "#error: stop");
    warns("#warning \"x\\ny\"", "x y");
}

/// Language facts, section 14.
#[test]
fn versions() {
    fails("#version 3.71;", "newer");
    prints("#version 3.5+0.2; F(version)", "3.700000 ");
    prints("#version 3.704; F(version)", "3.700000 ");
    prints("#version unofficial 3.7; F(version)", "3.700000 ");
    let (error, printed, warnings) =
        read(&[("main.pov", "#version 3.1; #declare A=1 #declare A=A+1 #debug str(A,0,0)")]);
    assert_eq!((error, &*printed), (None, "2"));
    assert!(warnings.iter().any(|w| w.contains("';' is missing")));
    let (_, _, warnings) = read(&[("main.pov", "")]);
    assert!(warnings.iter().any(|w| w.contains("#version")));
}

/// Language facts, section 15.
#[test]
fn directives_anywhere() {
    prints("#declare A = #if (1) 2; #else 3; #end F(A)", "2.000000 ");
    fails("#declare A = #if (1) 2 #else 3 #end;", "';'");
    prints("#declare A = (#if (1) 2 #else 3 #end); F(A)", "2.000000 ");
    prints("#macro M(n) n #end #declare A = M(1) + M(2)*3; F(A)", "7.000000 ");
    prints("#declare V = <#for(I,1,3) I, #end>; F(V.z)", "3.000000 ");
    fails("#declare V=x; #declare A = V. #if (1) y #end;", "component");
    prints("#declare A = 1 + #declare B = 2; B; F(A)", "3.000000 ");
    fails("#declare A #if (0) #end = 1;", "'='");
}

/// Whatever the bytes, there is an answer with a place.
fn refuses_bytes(bytes: &[u8], message: &str) {
    use super::Host as _;
    let host = Memory::default();
    assert!(host.append("main.pov".as_ref(), bytes).is_ok());
    let limits = Limits { steps: 10_000, ..Limits::strict() };
    let options = Options { limits, ..Options::default() };
    let start: String = String::from_utf8_lossy(&bytes[..bytes.len().min(40)]).into_owned();
    match evaluate("main.pov".as_ref(), &options, &host, &NoQueries) {
        Ok(_) => panic!("{start} was read"),
        Err(failed) => {
            let last = failed.diagnostics.last();
            let shown = last.map_or_else(String::new, |d| d.render(&failed.sources, false));
            assert!(shown.contains(message) && shown.contains("main.pov:"), "{start}: {shown}");
        }
    }
}

#[test]
fn bad_input_gets_an_answer() {
    let version = "#version 3.7; ";
    let with = |text: String| format!("{version}{text}").into_bytes();
    refuses_bytes(&with("#declare A = ".to_owned() + &"(".repeat(100_000)), "levels of braces");
    refuses_bytes(&with("#declare A = <".to_owned() + &"<".repeat(100_000)), "levels of braces");
    refuses_bytes(&with("#declare A = ".to_owned() + &"-".repeat(1_000_000)), "found the end of the file");
    refuses_bytes(&with("#declare A = ".to_owned() + &"1?".repeat(100_000)), "';'");
    refuses_bytes(&with("#declare A = (".to_owned() + &"1?".repeat(100_000)), "levels of braces");
    refuses_bytes(&with("#declare A = ".repeat(100_000)), "levels of braces");
    refuses_bytes(&with("#if (1) ".repeat(100_000)), "before the #end");
    refuses_bytes(&with("#if (0) ".repeat(100_000)), "no #end");
    refuses_bytes(&with("#if (".repeat(100_000)), "levels of braces");
    refuses_bytes(&with("/*".repeat(100_000)), "comments nest too deeply");
    refuses_bytes(&with("union { ".repeat(100_000)), "");
    refuses_bytes(&with("#macro M() M() #end M()".to_owned()), "macro calls inside one another");
    refuses_bytes(&with("#declare S = \"aaaaaaaa\"; #while (1) #declare S = concat(S, S) #end".to_owned()), "bytes");
    refuses_bytes(&with("#declare A = array[3000][3000][3000];".to_owned()), "elements");
    refuses_bytes(&with("x".repeat(1_000_000)), "255");
    refuses_bytes(&with("Q ".repeat(1_000_000)), "undeclared");
    refuses_bytes(&with("1,".repeat(1_000_000)), "found a number");
    refuses_bytes(&with("\"".to_owned() + &"a".repeat(1_000_000)), "never closed");
    refuses_bytes(&(0..=255).cycle().take(100_000).collect::<Vec<u8>>(), "");
    refuses_bytes(b"\x7fELF\x02\x01\x01\0\0\0\0\xff\xfe", "no meaning");
    refuses_bytes(b"sphere { \xe9 }", "no meaning");
}

#[test]
fn functions_at_their_edges() {
    check("sinh(1)", &[1.0_f64.sinh()]);
    check("asinh(1)", &[1.0_f64.asinh()]);
    check("acosh(2)", &[2.0_f64.acosh()]);
    check("acosh(0.5)", &[f64::NAN]);
    check("atanh(0.5)", &[0.5_f64.atanh()]);
    check("atanh(1)", &[f64::INFINITY]);
    check("tan(1)", &[1.0_f64.tan()]);
    check("exp(1)", &[std::f64::consts::E]);
    check("exp(1000)", &[f64::INFINITY]);
    check("mod(5,0)", &[f64::NAN]);
    check("max(3)", &[3.0]);
    check("asc(\"\")", &[0.0]);
    check("strcmp(\"abc\",\"ab\")", &[99.0]);
    check("val(\"1e3x\")", &[1000.0]);
    check("val(\"0x10\")", &[16.0]);
    check("val(\"x\")", &[0.0]);
    fails("F(atan2(0,0))", "atan2");
    fails("S(\"a\\qb\")", "escape");
    prints(
        "#declare A=array[2][3]{{1,2,3}{4,5,6}} F(dimension_size(A,3)) F(dimension_size(A,2))",
        "0.000000 3.000000 ",
    );
}

#[test]
fn vectors_at_their_edges() {
    check("x.y", &[0.0]);
    check("!x", &[0.0, 1.0, 1.0]);
    check("(1=x)", &[1.0, 0.0, 0.0]);
    check("u*2", &[2.0, 0.0]);
    check("1*t", &[0.0, 0.0, 0.0, 1.0]);
    check("(t)", &[0.0, 0.0, 0.0, 1.0]);
    check("x/0", &[f64::INFINITY; 3]);
    check("x+(5+u)", &[7.0, 5.0, 0.0]);
    fails("#declare A = x.t;", "no component");
}
