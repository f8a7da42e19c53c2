// A setting of radiosity outside of its range.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 50 nearest_count 30 } }
sphere { 0, 1 pigment { rgb 1 } }
