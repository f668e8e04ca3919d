// SPDX-License-Identifier: Apache-2.0
// The hashes by which ROS 2 (since Iron) compares types: those of its own message packages.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "idl_support/type_registry.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

/// As `ros2 topic info -v` prints them, and as the packages publish them.
const std::vector<std::pair<const char*, const char*>> published{
    {"action_msgs::msg::dds_::GoalStatusArray_",
     "RIHS01_6c1684b00f177d37438febe6e709fc4e2b0d4248dca4854946f9ed8b30cda83e"},
    {"action_msgs::msg::dds_::GoalStatus_",
     "RIHS01_32f4cfd717735d17657e1178f24431c1ce996c878c515230f6c5b3476819dbb9"},
    {"action_msgs::srv::dds_::CancelGoal_Request_",
     "RIHS01_3d3c84653c1f96918086887e1dcb236faec88b81a5b14fd4cf4840065bcdf8af"},
    {"action_msgs::srv::dds_::CancelGoal_Response_",
     "RIHS01_35e682cf3f510e83c70a82a4aac888496dedee56773bf9d8e5e0aa81f9e1c960"},
    {"builtin_interfaces::msg::dds_::Duration_",
     "RIHS01_e8d009f659816f758b75334ee1a9ca5b5c0b859843261f14c7f937349599d93b"},
    {"builtin_interfaces::msg::dds_::Time_",
     "RIHS01_b106235e25a4c5ed35098aa0a61a3ee9c9b18d197f398b0e4206cea9acf9c197"},
    {"composition_interfaces::srv::dds_::LoadNode_Request_",
     "RIHS01_7d3496175f54f92d652547e144c9b2a3b22afd604f84ed70adfcd1cfe35801b5"},
    {"composition_interfaces::srv::dds_::LoadNode_Response_",
     "RIHS01_08cdf942efabec2448fd03c131f3627a33ed05376400612425f871feb87ca9fd"},
    {"composition_interfaces::srv::dds_::UnloadNode_Request_",
     "RIHS01_95d5cfc357956740190c7685ac868d9c7c98dcb8c1416aae8eaa351422074e12"},
    {"diagnostic_msgs::msg::dds_::DiagnosticArray_",
     "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"},
    {"example_interfaces::action::dds_::Fibonacci_SendGoal_Request_",
     "RIHS01_3d088942b413247db536576f0286768c6be8fcd5d0c9a5d544f359fba090a238"},
    {"geometry_msgs::msg::dds_::Point_",
     "RIHS01_6963084842a9b04494d6b2941d11444708d892da2f4b09843b9c43f42a7f6881"},
    {"geometry_msgs::msg::dds_::PoseStamped_",
     "RIHS01_10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"},
    {"geometry_msgs::msg::dds_::PoseWithCovariance_",
     "RIHS01_9a7c0fd234b7f45c6098745ecccd773ca1085670e64107135397aee31c02e1bb"},
    {"geometry_msgs::msg::dds_::Pose_",
     "RIHS01_d501954e9476cea2996984e812054b68026ae0bfae789d9a10b23daf35cc90fa"},
    {"geometry_msgs::msg::dds_::Quaternion_",
     "RIHS01_8a765f66778c8ff7c8ab94afcc590a2ed5325a1d9a076ffff38fbce36f458684"},
    {"geometry_msgs::msg::dds_::TransformStamped_",
     "RIHS01_0a241f87d04668d94099cbb5ba11691d5ad32c2f29682e4eb5653424bd275206"},
    {"geometry_msgs::msg::dds_::Transform_",
     "RIHS01_beb83fbe698636351461f6f35d1abb20010c43d55374d81bd041f1ba2581fddc"},
    {"geometry_msgs::msg::dds_::TwistWithCovariance_",
     "RIHS01_49f574f033f095d8b6cd1beaca5ca7925e296e84af1716d16c89d38b059c8c18"},
    {"geometry_msgs::msg::dds_::Twist_",
     "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a"},
    {"geometry_msgs::msg::dds_::Vector3_",
     "RIHS01_cc12fe83e4c02719f1ce8070bfd14aecd40f75a96696a67a2a1f37f7dbb0765d"},
    {"lifecycle_msgs::msg::dds_::TransitionEvent_",
     "RIHS01_d5f8873a2f0146498f812d7885c7327ce27e463d36811d8792f35ee38c0d6c38"},
    {"lifecycle_msgs::srv::dds_::ChangeState_Request_",
     "RIHS01_d74c6f524e14cade7b67e7297190360ed749264af300524fc1456f27cc2a553a"},
    {"lifecycle_msgs::srv::dds_::GetAvailableTransitions_Response_",
     "RIHS01_4711339461aadf02bcfff797a198de911f885074bd3f2fe9f7b677ef87f0741c"},
    {"nav2_msgs::action::dds_::NavigateToPose_FeedbackMessage_",
     "RIHS01_9d1f6fa2eb975ce733b419ac2e97b134d8ff92b6478b6559feed9a50bdfd82b3"},
    {"nav2_msgs::action::dds_::NavigateToPose_Feedback_",
     "RIHS01_9ebc544c7d41bd8c6060b191bf9f5e4ddca6c2f61ee9e04fcb62ed5d67218a33"},
    {"nav2_msgs::action::dds_::NavigateToPose_GetResult_Request_",
     "RIHS01_106d3457cf0db4c4a8d3373bab3ff6aa8ba8ad99ae6392ce9784830a7d04ac93"},
    {"nav2_msgs::action::dds_::NavigateToPose_GetResult_Response_",
     "RIHS01_c59f178c377de5318919c00bdbf7884cb3b185acfdffceba6c9f161e0aa3cc81"},
    {"nav2_msgs::action::dds_::NavigateToPose_Goal_",
     "RIHS01_22a9dffbd6733011220460bd52edbc7843c8fc86282d40bc7ad3ca176a9dec10"},
    {"nav2_msgs::action::dds_::NavigateToPose_Result_",
     "RIHS01_ddbff7fc6d1e51d774d5defdb8398a57cb23fa8709355002d676408bb4860b85"},
    {"nav2_msgs::action::dds_::NavigateToPose_SendGoal_Request_",
     "RIHS01_e9381f2acfe9fa8c4838a277d0cde28a93c483564827b9f13496b9c2092e4f09"},
    {"nav2_msgs::action::dds_::NavigateToPose_SendGoal_Response_",
     "RIHS01_99f97fcbb07daf024df4b8c3f02f19ce7fa3183fcedfb76b8772a61a371a55fa"},
    {"nav_msgs::msg::dds_::Odometry_",
     "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"},
    {"nav_msgs::msg::dds_::Path_",
     "RIHS01_1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b"},
    {"rcl_interfaces::msg::dds_::Log_",
     "RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac"},
    {"rcl_interfaces::msg::dds_::LoggerLevel_",
     "RIHS01_95785cc42f048ab4f395af65035aeaf2181d8e1c7a44edb8ad4558445fdb43c0"},
    {"rcl_interfaces::msg::dds_::ParameterDescriptor_",
     "RIHS01_52175dbfda6c51153101d33d2a9da05743f66f02d5ab2ca9ec4709b46b73d704"},
    {"rcl_interfaces::msg::dds_::ParameterEvent_",
     "RIHS01_043e627780fcad87a22d225bc2a037361dba713fca6a6b9f4b869a5aa0393204"},
    {"rcl_interfaces::msg::dds_::SetLoggerLevelsResult_",
     "RIHS01_9316e5e679a5b72d2dd7fd80c539bae9e106fa0890a06dc5da3a8177a3ff6909"},
    {"rcl_interfaces::srv::dds_::SetLoggerLevels_Request_",
     "RIHS01_4e7768e0f4c749205f35bc05449f83fad18c42de52c16b1934d66c2f68ffd862"},
    {"rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_",
     "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e"},
    {"sensor_msgs::msg::dds_::BatteryState_",
     "RIHS01_4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741"},
    {"sensor_msgs::msg::dds_::CompressedImage_",
     "RIHS01_15640771531571185e2efc8a100baf923961a4d15d5569652e6cb6691e8e371a"},
    {"sensor_msgs::msg::dds_::Imu_",
     "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"},
    {"sensor_msgs::msg::dds_::JointState_",
     "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"},
    {"sensor_msgs::msg::dds_::Temperature_",
     "RIHS01_72514a14126ab9f8a9abec974c78e5610a367b59db5da355ff1fb982d5bad4b8"},
    {"std_msgs::msg::dds_::Bool_",
     "RIHS01_feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9"},
    {"std_msgs::msg::dds_::Empty_",
     "RIHS01_20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312"},
    {"std_msgs::msg::dds_::Header_",
     "RIHS01_f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01"},
    {"std_msgs::msg::dds_::Int16MultiArray_",
     "RIHS01_b58810e8e5b90fb19a5062469eb8409f5ab11a446d60de7157a1457e52a076ce"},
    {"std_msgs::msg::dds_::String_",
     "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"},
    {"std_srvs::srv::dds_::Trigger_Request_",
     "RIHS01_d010825374ce8918e72bfd826c82603e60f45419e932ea976f807b74a863a199"},
    {"tf2_msgs::msg::dds_::TFMessage_",
     "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
    {"unique_identifier_msgs::msg::dds_::UUID_",
     "RIHS01_1b8e8aca958cbea28fe6ef60bf6c19b683c97a9ef60bb34752067d0f2f7ab437"}};

TEST(TypeHash, OfRos2sTypesIsWhatRos2Publishes) {
  (void)type_info<std_msgs::msg::String>();  // whose library knows them all
  for (const auto& [name, hash] : published) {
    const TypeInfo* const type = find_type(name);
    ASSERT_NE(type, nullptr) << name;
    EXPECT_STREQ(type->ros_hash, hash) << name;
  }
}

}  // namespace
}  // namespace tocsin
