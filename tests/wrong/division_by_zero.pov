// Division by zero: infinite, and the sphere with it.
#declare Count = 0;
#declare Step = 1 / Count;
sphere { Step * x, 1 }
