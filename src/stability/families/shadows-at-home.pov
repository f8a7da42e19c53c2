//! about: a shape, number X of the zoo, seen from the light: nothing that is seen is in shadow
//! extremity: X
//! steps: 0 to 27 by 1
//! truth: the picture with Right declared
//! tolerance: 0
#version 3.7;
global_settings { assumed_gamma 1 }
#include "zoo.inc"
#declare Eye = <3, 5, -22>;
camera { location Eye look_at 0 angle 7 }
light_source { Eye, rgb 1 }
background { rgb <.05, .1, .2> }
object { Zoo[X] texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 } } rotate <20, 25, -10> #ifdef (Right) no_shadow #end }
