// superellipsoid: pillow, rounded box, pinched star and rounded cylinder.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

superellipsoid { <0.2, 0.2> scale 0.7 rotate <25, 30, 0> translate <-1.5, 1, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
superellipsoid { <1, 0.1> scale 0.7 rotate <60, 20, 0> translate <1.3, 1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
superellipsoid { <2.2, 2.2> rotate <20, 35, 0> translate <-1.4, -1.1, 0> pigment { rgb <0.3, 0.4, 0.9> } }
superellipsoid { <0.5, 1.6> scale 0.8 rotate <40, -20, 0> translate <1.4, -1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
