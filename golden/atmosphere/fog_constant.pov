// Constant fog: distance, filter, transmit, two fogs at once.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -7> look_at <0, 1.2, 0> angle 60 }
light_source { <-50, 70, -60> rgb 1 }
plane { y, 0 pigment { rgb <0.4, 0.5, 0.3> } }
#for (K, 0, 5)
  cone { <1.5 * K - 2.5, 0, 3 * K>, 0.6, <1.5 * K - 2.5, 2.5, 3 * K>, 0 pigment { rgb <0.7, 0.3, 0.2> } }
#end
sphere { <-2.5, 0.6, -2>, 0.6 pigment { rgb 0.1 } finish { reflection 0.7 } }

fog { fog_type 1 distance 25 color rgbft <0.7, 0.75, 0.8, 0.1, 0.1> }
fog { distance 80 color rgb <0.9, 0.5, 0.2> }
