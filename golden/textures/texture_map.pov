// texture_map: whole shaded textures are blended; patterns in patterns; average; finishes blended too.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#declare Shiny = texture { pigment { rgb <0.9, 0.7, 0.2> } finish { phong 0.9 phong_size 20 } }
#declare Dull = texture { pigment { rgb <0.3, 0.3, 0.6> } finish { ambient 0.2 diffuse 0.4 } }
sphere { <-2, 0.9, 0>, 0.9 texture { gradient y texture_map { [0.3 Shiny] [0.7 Dull] } scale 0.6 } }
sphere { <0, 0.9, 0>, 0.9 texture { bozo texture_map { [0.4 Shiny] [0.6 bozo texture_map { [0.5 Dull] [0.5 Shiny] } scale 0.3] } scale 0.4 } }
sphere { <2, 0.9, 0>, 0.9 texture { average texture_map { [1 Shiny] [3 Dull] } } }
box { -0.7, 0.7 rotate <20, 30, 0> translate <-2, -1, 0> texture { checker texture { Shiny } texture { Dull } scale 0.35 translate 0.1 } }
box { -0.7, 0.7 rotate <20, 30, 0> translate <0, -1, 0> texture { wood texture_map { [0.5 Shiny] [0.5 Dull] [1 Shiny] } scale 0.3 turbulence 0.1 } }
box { -0.7, 0.7 rotate <20, 30, 0> translate <2, -1, 0> texture { gradient x texture_map { [0 Dull] [1 pigment { rgbt <1, 0.5, 0.5, 0.8> }] } scale 1.43 translate -0.7 } }
