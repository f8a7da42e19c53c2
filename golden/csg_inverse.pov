// inverse: a difference written as an intersection with inverted solids, beside the difference itself.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Body = box { -0.9, 0.9 pigment { rgb <0.8, 0.3, 0.2> } }
#declare Bite = sphere { <0.4, 0.5, -0.8>, 0.8 pigment { rgb <0.9, 0.8, 0.3> } }
#declare Hole = torus { 0.8, 0.3 translate 0.9 * y pigment { rgb <0.3, 0.4, 0.9> } }

difference { object { Body } object { Bite } object { Hole } rotate 25 * y translate -1.5 * x }
intersection { object { Body } object { Bite inverse } object { Hole inverse } rotate 25 * y translate 1.5 * x }
