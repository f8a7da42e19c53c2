//! about: a sphere and a torus in 10^X unions, each turned within the next
//! extremity: 10^X
//! steps: 0 1 2 3 3.5 4
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare N = ceil(pow(10, X));
#declare O = union { sphere { <.3, .2, .1>, .6 } torus { 1, .2 } pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare I = 0;
#while (I < N)
  #declare O = union { object { O rotate 2520 / N * z } sphere { <0, 90 + I, 0>, .1 } }
  #declare I = I + 1;
#end
object { O }
