// ior and the ratio of two in single precision: the camera is in the sphere, whose cells lie 1000 units behind.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,-27,0> look_at <0.01,0,0> }
plane { -y, 24 pigment { rgbt 1 } interior { ior 1.5 } }
sphere { <0,-9,0>, 1000 pigment { bumps scale 0.0001 color_map { [0 rgb 0][1 rgb 1] } } finish { ambient 1 diffuse 0 } }
