//! about: two boxes one within the other, faces 10^X apart, at last in the same place: the union is one of them
//! extremity: 10^X
//! steps: -1 -3 -5 -7 -9 -11 -13 -15 -400
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare Gap = pow(10, X);
#declare Look = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#ifdef (Right)
  box { -1, 1 texture { Look } rotate 30*y }
#else
  merge { box { -1, 1 } box { -1 + Gap, 1 - Gap } intersection { box { -1, 1 } box { -1 - Gap, 1 + Gap } } texture { Look } rotate 30*y }
#end
