//! about: a sphere and a cone mirrored and moved 10^X times, in one list and in nested unions
//! extremity: 10^X
//! steps: 0.31 1 2 3 4
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
// Twice mirrored, moved there and back.
#declare N = 2 * ceil(pow(10, X) / 2);
#declare O = union { sphere { <.3, .2, .1>, .6 } cone { <-1, -1, 0>, .5, <-1, 1, .2>, .2 } pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare I = 0;
#while (I < N)
  #declare O = union { object { O scale <-1, 1, 1> translate (mod(I, 2) = 0 ? 1 : 1) * <.25, 0, 0> } }
  #declare I = I + 1;
#end
object { O #declare I = 0; #while (I < N) scale <1, -1, 1> translate .5*y #declare I = I + 1; #end }
