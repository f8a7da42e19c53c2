// torus: seen from the side, through the hole, and one that meets itself (minor radius above major).
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.6, -7> look_at 0 angle 44 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

torus { 0.8, 0.25 translate <-1.6, 0.7, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.7 } }
torus { 0.7, 0.3 rotate 70 * x translate <1.2, 0.8, 0> pigment { rgb <0.3, 0.7, 0.3> } }
torus { 0.4, 0.7 scale 0.7 rotate 30 * z translate <-1.2, -1, 0> pigment { rgb <0.9, 0.8, 0.4> } }
torus { 1, 0.05 rotate <20, 0, 30> translate <1.2, -1, 0> pigment { rgb <0.3, 0.4, 0.9> } }
