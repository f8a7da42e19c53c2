// slope and aoi on round bodies: direction, range, altitude, point_at, and with a bumpy normal.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
light_source { <-5, 7, -9> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#declare N = 0;
#macro Ball(T) sphere { 0.5, 0.48 texture { T } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end
#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
#declare F = finish { ambient 0 emission 0.9 diffuse 0 }
Ball(texture { pigment { slope y color_map { Map } } finish { F } })
Ball(texture { pigment { slope <1, 1, -0.5> color_map { Map } } finish { F } })
Ball(texture { pigment { slope { <1, 0, -1>, 0.3, 0.9 } color_map { Map } } finish { F } })
Ball(texture { pigment { slope { y, 0, 1 altitude x, 0, 1 } color_map { Map } } finish { F } })
Ball(texture { pigment { slope { point_at <2, 1.5, -2> } color_map { Map } } finish { F } })
Ball(texture { pigment { aoi color_map { Map } } finish { F } })
Ball(texture { pigment { slope y color_map { Map } } normal { bumps 0.6 scale 0.1 } finish { F } })
Ball(texture { pigment { aoi color_map { Map } frequency 2 } normal { ripples 0.4 scale 0.1 } finish { F } })
Ball(texture { slope y texture_map { [0.4 pigment { rgb <0.2, 0.5, 0.2> }] [0.6 pigment { rgb 0.9 } finish { phong 0.8 }] } })
Ball(texture { aoi texture_map { [0.6 pigment { rgb <0.7, 0.2, 0.1> }] [0.9 pigment { rgb <1, 0.8, 0.3> }] } })
Ball(texture { pigment { slope { <0, 1, 0>, 0.4, 0.6 } pigment_map { [0 checker scale 0.1 translate 0.013] [1 rgb <0.9, 0.5, 0.1>] } } finish { F } })
Ball(texture { pigment { slope x triangle_wave frequency 2 phase 0.3 color_map { Map } } finish { F } })
