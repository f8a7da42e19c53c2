// bokeh: a pigment gives the lens its shape.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -6> look_at 0 angle 40 aperture 0.9 focal_point <0, 0, -2> blur_samples 40 variance 0
  bokeh { pigment { gradient x color_map { [0.3 rgb 0] [0.3 rgb 1] } } } }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
plane { y, -0.8 pigment { rgb <0.6, 0.55, 0.5> } }
sphere { <-1.2, -0.1, -2>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } }
sphere { <0.6, 0.2, 1>, 0.7 pigment { rgb <0.3, 0.7, 0.3> } finish { emission 0.3 } }
sphere { <3, 1, 5>, 0.3 pigment { rgb 1 } finish { emission 1.5 } }
sphere { <-2, 2, 7>, 0.3 pigment { rgb <1, 0.9, 0.5> } finish { emission 1.5 } }
