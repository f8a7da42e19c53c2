//! about: the quartic (x^2 + y^2 + z^2 - 1)^2 = e^2 with e = 10^X, nearly a double root
//! extremity: 10^X
//! steps: -1 to -12 by -1
//! truth: what it finds
//! tolerance: 1e-3
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#declare E = pow(10, X);
// The outer sheet is at sqrt(1 + e): whatever is hit must be it.
#declare Q = quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, -2, 0, 0, 0, 0, 1, 0, -2, 0, 1 - E * E> sturm }
#declare S = seed(7);
#declare Missed = 0;
#declare I = 0;
#while (I < 300)
  #local D = vnormalize(<rand(S), rand(S), rand(S)> - .5);
  #local N = <0, 0, 0>;
  #local P = trace(Q, D * 3, -D, N);
  #if (vlength(N) = 0) #declare Missed = Missed + 1; #else #if (abs(vlength(P) - 1) > 1e-3 + E) #declare Missed = Missed + 1; #end #end
  #declare I = I + 1;
#end
#debug concat("found ", str(Missed / 300, 0, 20), "\n")
