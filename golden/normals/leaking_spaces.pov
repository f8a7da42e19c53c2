// The space of a patterned entry stays in force for the bumps of what is evaluated after it, as POV-Ray has it.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.2, -7> look_at <0, 0.1, 0> angle 44 }
light_source { <-5, 6, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#declare Bumpy = texture { pigment { rgb <0.9, 0.6, 0.3> } normal { bumps 0.9 scale 0.25 } finish { specular 0.4 } }
#declare Plain = texture { pigment { rgb <0.4, 0.5, 0.8> } finish { diffuse 0.7 } }
#declare Long = texture { checker texture { Plain } texture { Plain } scale <1, 6, 1> rotate 40 * z }
// Upper row: the lower entry's bumps with a plain and with a patterned upper entry; then the other way round.
sphere { <-2.3, 1, 0>, 1 texture { gradient y texture_map { [0 Bumpy] [1 Plain] } scale 2 } }
sphere { <0, 1, 0>, 1 texture { gradient y texture_map { [0 Bumpy] [1 Long] } scale 2 } }
sphere { <2.3, 1, 0>, 1 texture { gradient y texture_map { [0 Long] [1 Bumpy] } scale 2 } }
// Lower row: averages in both orders, and bumps that keep their depth.
box { -0.75, 0.75 rotate <-30, 25, 0> translate <-2.2, -1, 0> texture { average texture_map { [1 Bumpy] [1 Long] } } }
box { -0.75, 0.75 rotate <-30, 25, 0> translate <0, -1, 0> texture { average texture_map { [1 Long] [1 Bumpy] } } }
box { -0.75, 0.75 rotate <-30, 25, 0> translate <2.2, -1, 0> texture { average texture_map { [1 Long] [1 Bumpy] } no_bump_scale scale <1, 1.4, 0.9> } }
