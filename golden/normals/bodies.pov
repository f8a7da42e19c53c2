// Bumpy normals on round bodies in highlights and reflections.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.3 pigment { checker rgb 0.8 rgb 0.3 translate 0.1 } normal { ripples 0.15 scale 0.5 } finish { reflection 0.3 } }
sphere { -1.5 * x, 1.1 pigment { rgb <0.8, 0.5, 0.3> } normal { dents 0.8 scale 0.3 } finish { specular 0.6 } }
torus { 0.8, 0.35 rotate -60 * x translate 1.5 * x pigment { rgb <0.3, 0.5, 0.8> } normal { bumps 0.4 scale 0.15 } finish { phong 0.7 reflection 0.2 } }
