// A keyword used as a name.
#declare color = rgb 1;
