// #default: pigment, finish and normal given once; a pigment that starts from the default; later defaults win.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#default { pigment { gradient x color_map { [0 rgb <0.8, 0.3, 0.2>] [1 rgb <0.9, 0.9, 0.4>] } scale 0.4 } finish { phong 0.7 ambient 0.2 } }
sphere { -2 * x, 0.9 }
sphere { 0, 0.9 pigment { gradient y } }
#default { normal { bumps 0.4 scale 0.1 } }
sphere { 2 * x, 0.9 }
box { <-2.5, -1.6, -0.3>, <2.5, -1.1, 0.3> pigment { rgb <0.4, 0.5, 0.7> } }
