//! about: superellipsoids of exponents 10^X: stars ever thinner
//! extremity: 10^X
//! steps: 0 .5 1 1.5 2 3
//! truth: what it finds
//! tolerance: 1e-6
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#declare E = pow(10, X);
#declare Shape = superellipsoid { <E, E> }
// Along its six spikes it ends at 1.
#declare I = 0;
#while (I < 6)
  #local D = (mod(I, 3) = 0 ? x : (mod(I, 3) = 1 ? y : z)) * (I < 3 ? 1 : -1);
  #local N = <0, 0, 0>;
  #local P = trace(Shape, D * 4, -D, N);
  #debug concat("found ", str((vlength(N) = 0 ? 1 : abs(vlength(P) - 1)), 0, 20), "\n")
  #declare I = I + 1;
#end
