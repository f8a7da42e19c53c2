// A fisheye camera's normal is looked up by an angle between -90 and 270 degrees: the seam runs down, not to the left.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { fisheye location 0 angle 160 right x normal { bumps 0.2 scale 3 } }
sphere { 0, 100 pigment { checker rgb <0.9, 0.9, 0.4>, rgb <0.2, 0.3, 0.7> scale 20 } finish { ambient 1 } }
