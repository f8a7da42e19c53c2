// What `uv_mapping` stands before is an entry of a map: a pattern written over it shows it at the plain point, moved by
// what was written after the whole pigment or normal. Maps also outlast plain colours and pictures written over them.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0.1, -8> look_at <0, -0.05, 0> angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0.3 } }
#declare Hues = color_map { [0 rgb <0.8, 0.3, 0.2>] [0.5 rgb <0.9, 0.9, 0.4>] [1 rgb <0.2, 0.3, 0.7>] }
#declare Mapped = pigment { uv_mapping gradient x color_map { Hues } scale 0.17 }
#declare Bumps = normal { uv_mapping gradient x 1 scale 0.11 }
#macro Ball(X, Y) sphere { 0, 0.6 translate <X, Y, 0> #end
Ball(-2.1, 1.4) pigment { Mapped } }
Ball(-0.7, 1.4) pigment { Mapped } pigment { gradient y } }
Ball(0.7, 1.4) pigment { Mapped turbulence 0.3 scale 2 } pigment { gradient y } }
Ball(2.1, 1.4) pigment { Mapped scale 0.4 } }
Ball(-2.1, 0) pigment { Mapped } pigment { rgb 1 } pigment { wood scale 0.6 } }
Ball(-0.7, 0) pigment { Mapped } pigment { color_map { [0 rgb <0.2, 0.7, 0.4>] [1 rgb 1] } } }
Ball(0.7, 0) pigment { Mapped } pigment { checker scale 0.3 } }
Ball(2.1, 0) pigment { gradient x color_map { Hues } scale 0.3 } pigment { rgb 1 } pigment { gradient y } }
Ball(-2.1, -1.4) pigment { rgb 1 } normal { Bumps } }
Ball(-0.7, -1.4) pigment { rgb 1 } normal { Bumps gradient y 1 scale 2 } }
Ball(0.7, -1.4) pigment { rgb 1 } normal { Bumps bump_size 3 scale 3 } }
Ball(2.1, -1.4) pigment { rgb 1 } normal { bumps 2 scale 0.2 } normal { uv_mapping gradient y } }
