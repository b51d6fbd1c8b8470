! A twist-beam axle: two trailing arms joined by a torsion bar; the left arm is lifted.
!
defaults units  &
   length = mm  &
   angle = deg  &
   force = newton  &
   mass = kg  &
   time = sec
!
model create  &
   model_name = axle
!
defaults coordinate_system  &
   default_coordinate_system = .axle.ground
!
marker create  &
   marker_name = .axle.ground.left_pivot  &
   location = 0.0, 600.0, 0.0  &
   orientation = 180.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .axle.ground.right_pivot  &
   location = 0.0, -600.0, 0.0  &
   orientation = 180.0d, 90.0d, 0.0d
!
part create rigid_body name_and_position  &
   part_name = .axle.left_arm  &
   location = 0.0, 600.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .axle.left_arm
!
marker create  &
   marker_name = .axle.left_arm.cm  &
   location = 300.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .axle.left_arm.pivot  &
   location = 0.0, 0.0, 0.0  &
   orientation = 180.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .axle.left_arm.wheel  &
   location = 400.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .axle.left_arm.bar  &
   location = 0.0, 0.0, 0.0  &
   orientation = 90.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .axle.left_arm  &
   mass = 12.0  &
   center_of_mass_marker = .axle.left_arm.cm  &
   ixx = 2.0E+05  &
   iyy = 4.0E+05  &
   izz = 4.0E+05
!
defaults coordinate_system  &
   default_coordinate_system = .axle.ground
!
part create rigid_body name_and_position  &
   part_name = .axle.right_arm  &
   location = 0.0, -600.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .axle.right_arm
!
marker create  &
   marker_name = .axle.right_arm.cm  &
   location = 300.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .axle.right_arm.pivot  &
   location = 0.0, 0.0, 0.0  &
   orientation = 180.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .axle.right_arm.wheel  &
   location = 400.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .axle.right_arm.bar  &
   location = 0.0, 0.0, 0.0  &
   orientation = 90.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .axle.right_arm  &
   mass = 12.0  &
   center_of_mass_marker = .axle.right_arm.cm  &
   ixx = 2.0E+05  &
   iyy = 4.0E+05  &
   izz = 4.0E+05
!
defaults coordinate_system  &
   default_coordinate_system = .axle.ground
!
force create element_like beam  &
   beam_name = .axle.torsion_bar  &
   i_marker_name = .axle.left_arm.bar  &
   j_marker_name = .axle.right_arm.bar  &
   length = 1200.0  &
   area_of_cross_section = 380.1327111  &
   y_shear_area_ratio = 1.1111  &
   z_shear_area_ratio = 1.1111  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80000.0  &
   ixx = 22998.02902  &
   iyy = 11499.01451  &
   izz = 11499.01451  &
   damping_ratio = 2.0E-02  &
   formulation = linear
!
constraint create joint revolute  &
   joint_name = .axle.left_joint  &
   i_marker_name = .axle.left_arm.pivot  &
   j_marker_name = .axle.ground.left_pivot
!
constraint create joint revolute  &
   joint_name = .axle.right_joint  &
   i_marker_name = .axle.right_arm.pivot  &
   j_marker_name = .axle.ground.right_pivot
!
constraint create motion_generator  &
   motion_name = .axle.lift  &
   joint_name = .axle.left_joint  &
   type_of_freedom = rotational  &
   function = "STEP(TIME, 0.0, 0.0D, 1.0, -8.0D)"
!
force create direct single_component_force  &
   single_component_force_name = .axle.wheel_load  &
   type_of_freedom = translational  &
   action_only = on  &
   i_marker_name = .axle.right_arm.wheel  &
   j_marker_name = .axle.right_arm.wheel  &
   function = "STEP(TIME, 1.0, 0.0, 1.5, 300.0)"
!
output_control create request  &
   request_name = .axle.ANGLE  &
   f2 = "AZ(.axle.left_arm.pivot, .axle.ground.left_pivot) * RTOD"  &
   f3 = "AZ(.axle.right_arm.pivot, .axle.ground.right_pivot) * RTOD"
!
output_control create request  &
   request_name = .axle.BAR  &
   output_type = force  &
   i_marker_name = .axle.left_arm.bar  &
   j_marker_name = .axle.right_arm.bar  &
   r_marker_name = .axle.right_arm.bar
!
simulation single_run transient  &
   model_name = .axle  &
   type = dynamic  &
   end_time = 4.0  &
   number_of_steps = 400
