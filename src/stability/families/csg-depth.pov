//! about: a sphere under 10^X nested differences that take nothing away
//! extremity: 10^X
//! steps: 0 1 2 2.5 3 3.5 4
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare O = sphere { <.3, .2, .1>, 1 }
#declare I = 0;
#while (I < pow(10, X))
  #declare O = difference { object { O } sphere { <0, 50 + I, 0>, 1 } }
  #declare I = I + 1;
#end
object { O pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
