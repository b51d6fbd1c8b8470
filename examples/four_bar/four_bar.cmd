! A parallelogram four-bar: crank driven at 90 deg/s, coupler stays level, rocker follows.
!
defaults units  &
   length = mm  &
   angle = deg  &
   force = newton  &
   mass = kg  &
   time = sec
!
model create  &
   model_name = four_bar
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.ground
!
marker create  &
   marker_name = .four_bar.ground.crank_pivot  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.ground.rocker_pivot  &
   location = 400.0, 0.0, 0.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
part create rigid_body name_and_position  &
   part_name = .four_bar.crank  &
   location = 0.0, 0.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.crank
!
marker create  &
   marker_name = .four_bar.crank.cm  &
   location = 0.0, 0.0, 100.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.crank.pivot  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.crank.pin  &
   location = 0.0, 0.0, 200.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .four_bar.crank  &
   mass = 1.0  &
   center_of_mass_marker = .four_bar.crank.cm  &
   ixx = 3.4E+03  &
   iyy = 3.4E+03  &
   izz = 1.0E+02
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.ground
!
part create rigid_body name_and_position  &
   part_name = .four_bar.coupler  &
   location = 0.0, 0.0, 200.0
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.coupler
!
marker create  &
   marker_name = .four_bar.coupler.cm  &
   location = 200.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.coupler.left  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.coupler.right  &
   location = 400.0, 0.0, 0.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .four_bar.coupler  &
   mass = 2.0  &
   center_of_mass_marker = .four_bar.coupler.cm  &
   ixx = 1.0E+02  &
   iyy = 2.7E+04  &
   izz = 2.7E+04
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.ground
!
part create rigid_body name_and_position  &
   part_name = .four_bar.rocker  &
   location = 400.0, 0.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.rocker
!
marker create  &
   marker_name = .four_bar.rocker.cm  &
   location = 0.0, 0.0, 100.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.rocker.pivot  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
marker create  &
   marker_name = .four_bar.rocker.pin  &
   location = 0.0, 0.0, 200.0  &
   orientation = 0.0d, 90.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .four_bar.rocker  &
   mass = 1.0  &
   center_of_mass_marker = .four_bar.rocker.cm  &
   ixx = 3.4E+03  &
   iyy = 3.4E+03  &
   izz = 1.0E+02
!
defaults coordinate_system  &
   default_coordinate_system = .four_bar.ground
!
constraint create joint revolute  &
   joint_name = .four_bar.crank_joint  &
   i_marker_name = .four_bar.crank.pivot  &
   j_marker_name = .four_bar.ground.crank_pivot
!
constraint create joint spherical  &
   joint_name = .four_bar.left_pin  &
   i_marker_name = .four_bar.coupler.left  &
   j_marker_name = .four_bar.crank.pin
!
constraint create joint cylindrical  &
   joint_name = .four_bar.right_pin  &
   i_marker_name = .four_bar.coupler.right  &
   j_marker_name = .four_bar.rocker.pin
!
constraint create joint revolute  &
   joint_name = .four_bar.rocker_joint  &
   i_marker_name = .four_bar.rocker.pivot  &
   j_marker_name = .four_bar.ground.rocker_pivot
!
constraint create motion_generator  &
   motion_name = .four_bar.drive  &
   joint_name = .four_bar.crank_joint  &
   type_of_freedom = rotational  &
   function = "90.0D * TIME"
!
force create body gravitational  &
   gravity_field_name = gravity  &
   x_component_gravity = 0.0  &
   y_component_gravity = 0.0  &
   z_component_gravity = -9806.65
!
output_control create request  &
   request_name = .four_bar.ANGLE  &
   f2 = "AZ(.four_bar.crank.pivot, .four_bar.ground.crank_pivot) * RTOD"  &
   f3 = "AZ(.four_bar.rocker.pivot, .four_bar.ground.rocker_pivot) * RTOD"
!
output_control create request  &
   request_name = .four_bar.COUPLER  &
   output_type = displacement  &
   i_marker_name = .four_bar.coupler.cm  &
   j_marker_name = .four_bar.ground.crank_pivot
!
simulation single_run transient  &
   model_name = .four_bar  &
   type = auto_select  &
   end_time = 0.9  &
   number_of_steps = 180
