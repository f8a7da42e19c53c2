// Densities move with what is written after them: in the density, the media, the object and the union.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -6> look_at 0 angle 40 }
plane { -z, -4 pigment { rgb <0.3, 0.35, 0.5> } finish { ambient 1 diffuse 0 } }
#declare Stripes = density { gradient x color_map { [0 rgb 0] [0.5 rgb 0] [0.5 rgb 1] [1 rgb 1] } scale 0.9 rotate 20*z }
#declare M = media { emission <0.8, 0.4, 0.1> absorption 0.5 samples 20 density { Stripes scale 0.7 } rotate 30*y translate 0.1*x }
#declare Ball = sphere { 0, 0.8 hollow pigment { rgbt 1 } interior { media { M scale 0.9 } } rotate -15*z rotate 40*y }
union {
  object { Ball translate -1*x }
  object { Ball scale <0.8, 1.2, 1> rotate 30*z translate 1*x }
  rotate 10*z
}
