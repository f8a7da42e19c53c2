// orthographic camera: parallel rays; near and far bodies have the same size.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <4, 4, -6> look_at <0, 0.4, 0.8> right 6 * x up 4.5 * y }
light_source { <-5, 7, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } }
#for (K, 0, 3)
  box { <-0.4, 0, -0.4>, <0.4, 1, 0.4> translate <-1.5 + K, 0, -1.5 + 1.6 * K> pigment { rgb <0.8, 0.2 + 0.2 * K, 0.2> } }
#end
