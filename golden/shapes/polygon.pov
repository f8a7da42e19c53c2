// polygon: one with a hole, a star that crosses itself, and one turned in space.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

polygon { 10, <0, 0>, <2, 0>, <2, 2>, <0, 2>, <0, 0>, <0.5, 0.5>, <1.5, 0.7>, <1.2, 1.5>, <0.6, 1.3>, <0.5, 0.5>
  rotate 20 * y translate <-2.6, -1, 0> pigment { rgb <0.8, 0.3, 0.2> } }
polygon { 6, #for (K, 0, 4) <sin(K * 4 * pi / 5), cos(K * 4 * pi / 5), 0>, #end <0, 1, 0>
  scale 1.1 translate <1.4, 0.7, 0> pigment { rgb <0.9, 0.8, 0.3> } }
polygon { 5, <-1, 0, -1>, <1, 0.4, -1>, <1, 0.4, 1>, <-1, 0, 1>, <-1, 0, -1>
  rotate <-20, 30, 10> translate <1.2, -1.2, 0> pigment { checker rgb 1 rgb <0.3, 0.4, 0.9> scale 0.4 translate 0.11 } }
