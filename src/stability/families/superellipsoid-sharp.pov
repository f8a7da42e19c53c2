//! about: superellipsoids of exponents 10^X and 10^-X, along 500 rays to the middle
//! extremity: 10^X
//! steps: 0 to -6 by -1
//! truth: what it finds
//! tolerance: 1e-6
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#declare E = pow(10, X);
#macro Surface(D, A, B)
  // In units of the greatest part, or powers would leave all numbers.
  #local Wide = max(abs(D.x), abs(D.y));
  #local Round = Wide * pow(pow(abs(D.x) / Wide, 2 / A) + pow(abs(D.y) / Wide, 2 / A), A / 2);
  #local Great = max(Round, abs(D.z));
  1 / (Great * pow(pow(Round / Great, 2 / B) + pow(abs(D.z) / Great, 2 / B), B / 2))
#end
#macro Check(A, B)
  #local Shape = superellipsoid { <A, B> }
  #local S = seed(5);
  #local Worst = 0;
  #local I = 0;
  #while (I < 250)
    #local D = vnormalize(<rand(S), rand(S), rand(S)> - .5);
    #local R = Surface(D, A, B);
    #local N = <0, 0, 0>;
    #local P = trace(Shape, D * 4, -D, N);
    #local Worst = max(Worst, (vlength(N) = 0 ? 1 : abs(vlength(P) / R - 1)));
    #local I = I + 1;
  #end
  #debug concat("found ", str(Worst, 0, 20), "\n")
#end
Check(E, E)
Check(1, E)
Check(E, 1)
