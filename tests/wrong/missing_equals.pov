// A declaration without its equals sign.
#declare Radius 2;
sphere { 0, Radius }
