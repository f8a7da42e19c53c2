// Known only once all settings are read.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { minimum_reuse .3 maximum_reuse .2 } }
sphere { 0, 1 pigment { rgb 1 } }
