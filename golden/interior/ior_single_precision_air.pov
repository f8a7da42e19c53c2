// ior in single precision, its reciprocal not: where air is on one side. A sky of fine cells shows directions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,-27,0> look_at <0.01,0,0> }
sky_sphere { pigment { bumps scale 2e-7 color_map { [0 rgb 0][1 rgb 1] } } }
plane { -y, 24 pigment { rgbt 1 } interior { ior 1.3 } }
