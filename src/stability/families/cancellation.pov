//! about: sums in expressions and functions from which 10^X is taken away again
//! extremity: 10^X
//! steps: 0 to 15 by 1
//! truth: what it finds
//! tolerance: 1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
// In units of the last place of 10^X: nothing is done in less than double precision.
#declare Big = pow(10, X);
#declare F = function(x, y) { (x + y) - y }
#debug concat("found ", str(abs((1/3 + Big) - Big - 1/3) / (Big * 2.3e-16), 0, 20), "\n")
#debug concat("found ", str(abs(F(1/3, Big) - 1/3) / (Big * 2.3e-16), 0, 20), "\n")
#debug concat("found ", str(abs(vdot(<Big, 1/3, 1>, <1, 1, -Big>) - 1/3) / (Big * 4.6e-16), 0, 20), "\n")
