! The Princeton beam: a strip of aluminium, 508 mm long, 12.377 mm wide (along z) and 3.2024 mm thick (along y),
! E = 71.7 GPa, Poisson's ratio 0.31. Read after beams.cmd.
macro create macro_name = strip user_entered_command = "strip" wrap_in_undo = no commands_to_be_executed =  &
   "!$n:t=integer:gt=0",  &
   "!$formulation:t=list(linear,string,nonlinear):d=linear",  &
   "!$j_at:t=list(root,tip):d=root",  &
   "!$wide:t=real:d=12.377E-3",  &
   "!$thick:t=real:d=3.2024E-3",  &
   "!$e:t=real:d=71.7E9",  &
   "! The shear area is 5/6 of the section; the chain has a shear modulus of 1, so it wants EA over that stiffness.",  &
   "! Torsion of a rectangle: w t^3 / 3 (1 - 0.63 t / w (1 - (t / w)^4 / 12)), G = E / 2.62.",  &
   "chain n = $n formulation = $formulation j_at = $j_at length = 0.508 ea = (eval($e*$wide*$thick)) ei_z = (eval($e*$wide*$thick**3/12.0)) ei_y = (eval($e*$thick*$wide**3/12.0)) gj = (eval($e/2.62*$wide*$thick**3/3.0*(1.0-0.63*$thick/$wide*(1.0-($thick/$wide)**4/12.0)))) shear_y = (eval(2.62*6.0/5.0)) shear_z = (eval(2.62*6.0/5.0))"
!
! A load of p N at the tip, so many degrees off the stiff axis.
macro create macro_name = strip_load user_entered_command = "strip load" wrap_in_undo = no commands_to_be_executed =  &
   "!$p:t=real",  &
   "!$angle:t=real",  &
   "tip force z = \"$p*cos($angle*pi/180)\" y = \"$p*sin($angle*pi/180)\""
