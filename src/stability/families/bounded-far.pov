//! about: a plane in a bounding box, the whole scene moved by 10^X times <1, .7, .3>
//! extremity: 10^X
//! steps: 0 2 4 6 7 8 9 10 11 12
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
#declare O = <1, .7, .3> * (X > 0 ? pow(10, X) : 0);
#declare Forward = vnormalize(<-2, -2.5, 4>);
#declare Aside = vnormalize(vcross(y, Forward));
camera { location O + <2, 2.5, -4> direction Forward right Aside * .8 up vcross(Forward, Aside) * .6 }
light_source { O + <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
plane { y, 0 bounded_by { box { -1.5, 1.5 } } pigment { rgb 1 } finish { ambient 0 diffuse 1 } translate O }
quadric { <1, 0, 1>, 0, 0, -.25 bounded_by { box { -1, 1 } } pigment { rgb x } finish { ambient 0 diffuse 1 } translate O }
