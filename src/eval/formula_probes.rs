//! What stands in a loop is read by its tokens the first time and walked as a tree from then on;
//! both must give the same.

use super::{Memory, NoQueries, Options, evaluate};

const SETUP: &str = "#version 3.7;
    #declare A = 3; #declare V = <1, 2, 3>; #declare C = rgbft <.1, .2, .3, .4, .5>; #declare S = \"abc\";
    #declare L = array[3] { 5, 6, 7 } #declare LL = array[2][2] { { 1, 2 } { 3, 4 } } #declare R = seed(1);
    #declare F = function(a, b) { a * b + 1 } #declare SP = spline { linear_spline 0, x, 1, y }
    #macro Sum(P, Q) P + Q #end #macro Group(P, Q) (P + Q) #end #macro Same(P) P #end
    #macro Local(P) #local T = P * 2; T #end #macro Unit(P) vnormalize(<P, 1, 2>) #end
    #macro Twice(P) #declare P = P * 2; P #end
    #macro Choose(P) #local T = 0; #if (P > 2) #local T = 10; #else #local T = 20; #end (T + P) #end
    #macro Count(N) #local T = 0; #for (K, 1, N) #local T = T + K; #end T #end
    #macro Deep(N) #local T = 1; #if (N > 1) #local T = N * Deep(N - 1); #end (T) #end
    #macro Outer(P) Group(Local(P), 1) * 2 #end #macro Shadow(A) #local V = A; V * 2 #end
    #macro Semi(P) P; #end #macro Text(P) concat(P, \"!\") #end #macro Sign(P) -P #end #macro Not(P) !P #end
    #macro Pick(P, I) P[I] #end #macro Open() < #end #macro Called(P) F(P, 2) #end #macro Curve(P) SP(P) #end
    #macro Nothing() #end #macro Draw() rand(R) #end #macro Long() #local T = trace(O, 0, z); T.z #end
    #declare O = sphere { 0, 1 }\n";

/// Reads the text four times over; what each turn printed.
fn turns(text: &str) -> Vec<String> {
    let scene = format!("{SETUP} #for (Turn, 1, 4) {text} #debug \"\\n\" #end");
    let host = Memory::new([("main.pov", scene.as_str())]);
    if let Err(failed) = evaluate("main.pov".as_ref(), &Options::default(), &host, &NoQueries) {
        panic!("{text}\n{}", failed.diagnostics.iter().map(|d| &*d.message).collect::<Vec<_>>().join("\n"));
    }
    host.messages().lines().map(str::to_owned).collect()
}

/// Every turn gives this, to three digits, in a declaration, in parentheses and as a component.
fn check(expression: &str, expected: &str) {
    for text in [
        format!("#declare X = {expression}; #debug vstr(3, X, \" \", 0, 3)"),
        format!("#declare X = 0 + ({expression}); #debug vstr(3, X, \" \", 0, 3)"),
        format!("#local X = {expression}; #local Y = 1 * X; #debug vstr(3, Y, \" \", 0, 3)"),
    ] {
        assert_eq!(turns(&text), [expected; 4], "{text}");
    }
}

#[test]
fn operators_and_functions() {
    check("A * 2 - V / 2", "5.500 5.000 4.500");
    check("-V.y + (A + 1).x * L[1] - LL[1][0]", "19.000 0.000 0.000");
    check("V * vlength(V) / sqrt(14) + vdot(V, x)", "2.000 3.000 4.000");
    check("vcross(x, y) + vaxis_rotate(x, z, 90) * 2", "0.000 2.000 1.000");
    check("vrotate(x, 90 * y).z + <A, 2>.y", "1.000 0.000 0.000");
    check("+A - +V", "2.000 1.000 0.000");
    check("F(A, F(1, 2)) + max(1, A, 2) + mod(7, 4) + pow(2, 3)", "24.000 0.000 0.000");
    check("SP(0.5) * 2 + C.red", "1.100 1.100 0.100");
}

#[test]
fn macros_are_operands() {
    check("2 * Group(A, 1) + Unit(0).z * sqrt(5)", "10.000 0.000 0.000");
    check("Sum(A, V)", "4.000 5.000 6.000");
    check("Same(V) * Same(A)", "3.000 6.000 9.000");
    check("<Local(A), Sum(1, 2), Same(4)> + Local(1)", "8.000 5.000 6.000");
    check("Choose(A) + Choose(1)", "34.000 0.000 0.000");
    check("Count(4) * Deep(4)", "240.000 0.000 0.000");
    check("Outer(A)", "14.000 0.000 0.000");
    check("Shadow(A) + V", "7.000 8.000 9.000");
    check("Pick(L, 1) + Pick(L, 0 + 0) * 0 + 1", "7.000 0.000 0.000");
    check("Called(A) + Curve(0.25)", "7.750 7.250 7.000");
    check("abs(Same(-2)) + vlength(Same(x)) + max(Same(1), Sum(1, 2))", "6.000 0.000 0.000");
    check("2 - Sign(1) + 3 * Sign(2) - Sign(Sign(1))", "-4.000 0.000 0.000");
    check("Not(1) + !Not(1)", "1.000 0.000 0.000");
}

#[test]
fn macros_that_splice_are_read_by_their_tokens() {
    check("2 * Sum(A, 1)", "7.000 0.000 0.000");
    check("-Sum(A, 1) * 2", "-1.000 0.000 0.000");
    check("Open() 1, 2, 3 >", "1.000 2.000 3.000");
    check("Nothing() A * Nothing() 2", "6.000 0.000 0.000");
    check("Same(V).y", "2.000 0.000 0.000");
    assert_eq!(turns("#declare X = Semi(A) #debug str(X, 0, 1)"), ["3.0"; 4]);
    assert_eq!(turns("#debug Text(Same(S)) #if (Same(S) = Same(S)) #debug \"=\" #end"), ["abc!="; 4]);
    assert_eq!(turns("#declare X = Same(S); #debug X"), ["abc"; 4]);
    assert_eq!(turns("object { Same(O) } #debug str(max_extent(Same(O)).x, 0, 1)"), ["0.0"; 4]);
}

#[test]
fn arguments_go_by_reference() {
    assert_eq!(turns("#declare X = 0 + Twice(A); #debug str(A, 0, 0)"), ["6", "12", "24", "48"]);
    assert_eq!(turns("#declare X = 1 * Twice(L[1]); #debug str(L[1], 0, 0)"), ["12", "24", "48", "96"]);
    assert_eq!(turns("#local Q = A; #declare X = 1 * Twice(Q) + Twice((Q)); #debug str(Q, 0, 0)"), ["6"; 4]);
    assert_eq!(turns("#local Q = A; #declare X = 1 * Twice(+Q) + Twice(Q + 0); #debug str(Q, 0, 0)"), ["3"; 4]);
}

#[test]
fn random_numbers_come_in_order() {
    let expected = "0.421993 0.487121 0.909114";
    let text = "#declare R = seed(1); #declare X = Draw(); #declare Y = 1 * Draw();
        #debug concat(str(X, 0, 6), \" \", str(Y, 0, 6), \" \", str(X + Y, 0, 6))";
    assert_eq!(turns(text), [expected; 4]);
}

#[test]
fn errors_inside_have_their_trail() {
    let scene = format!("{SETUP} #macro Bad(P) sqrt(P) #end #for (Turn, 1, 4) #declare X = 1 + Bad(3 - Turn); #end");
    let host = Memory::new([("main.pov", scene.as_str())]);
    let failed = evaluate("main.pov".as_ref(), &Options::default(), &host, &NoQueries).map(drop).unwrap_err();
    let last = failed.diagnostics.last().map(|d| (d.message.clone(), d.trace.len()));
    assert_eq!(last, Some(("square root of the negative number -1".to_owned(), 1)));
}
