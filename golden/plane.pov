// plane: a floor, a tilted wall and a ceiling, all without end.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -5> look_at <0, 1, 0> angle 60 }
light_source { <1, 2.5, -2> rgb 1 }

plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.3, 0.2, 0.1> } }
plane { <1, 0.3, -0.6>, -3 pigment { gradient y color_map { [0 rgb <0.2, 0.4, 0.8>] [1 rgb <0.8, 0.9, 1>] } } }
plane { -y, -3 pigment { rgb <0.5, 0.8, 0.6> } }
