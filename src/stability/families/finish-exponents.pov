//! about: highlights and fading of exponent 10^X, brilliance of 10^-X: they become what they tend to
//! extremity: 10^X
//! steps: 7 to 15 by 2, 30 100 300
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
#declare E = pow(10, X);
camera { location <2, 2.5, -4> look_at 0 angle 60 }
light_source { <6, 9, -7>, #ifdef (Right) rgb 2 #else rgb 1 fade_distance 1e3 fade_power E #end }
background { rgb <.1, .2, .3> }
#macro Ball(Place, Highlight) sphere { Place, .7 pigment { rgb .8 } finish { ambient 0 diffuse .4 Highlight } } #end
// The limits: no highlight, light everywhere alike.
#ifdef (Right)
  sphere { -1.6*x, .7 pigment { rgb .8 } finish { ambient 0 diffuse .4 } }
  sphere { 0, .7 pigment { rgb .8 } finish { ambient 0 diffuse .4 } }
#else
  sphere { -1.6*x, .7 pigment { rgb .8 } finish { ambient 0 diffuse .4 phong .5 phong_size E } }
  sphere { 0, .7 pigment { rgb .8 } finish { ambient 0 diffuse .4 specular .5 roughness 1 / E } }
#end
sphere { 1.6*x, .7 pigment { rgb .8 } finish { ambient 0 diffuse .4 brilliance #ifdef (Right) 0 #else 1 / E #end } }
