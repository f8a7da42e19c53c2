// sky_sphere with emission, over a background that shows through its filter.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -7> look_at <0, 1.2, 0> angle 60 }
light_source { <-50, 70, -60> rgb 1 }
plane { y, 0 pigment { rgb <0.4, 0.5, 0.3> } }
#for (K, 0, 5)
  cone { <1.5 * K - 2.5, 0, 3 * K>, 0.6, <1.5 * K - 2.5, 2.5, 3 * K>, 0 pigment { rgb <0.7, 0.3, 0.2> } }
#end
sphere { <-2.5, 0.6, -2>, 0.6 pigment { rgb 0.1 } finish { reflection 0.7 } }

background { rgb <0.2, 0.6, 0.3> }
sky_sphere { pigment { gradient x color_map { [0 rgbt <0.8, 0.2, 0.2, 0.8>] [1 rgbf <0.2, 0.2, 0.8, 0.6>] } scale 0.4 } emission rgb <1.5, 1, 0.5> }
