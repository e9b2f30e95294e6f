// The half of bench/ros in roscpp: publish TYPE SIZE SECONDS, subscribe TYPE SECONDS, serve, call COUNT.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>

using Clock = std::chrono::steady_clock;

static double since(Clock::time_point from)
{
  return std::chrono::duration<double>(Clock::now() - from).count();
}

template <typename Message>
static void publish(ros::NodeHandle& node, size_t size, double seconds)
{
  // What waits is dropped at last, the oldest first: enough that nobody waits for the one who sends.
  auto publisher = node.advertise<Message>("/bench", size > 100000 ? 20 : 20000);
  while (publisher.getNumSubscribers() == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  Message message;
  message.data.resize(size, 'x');
  auto from = Clock::now();
  while (since(from) < seconds)
    publisher.publish(message);
}

template <typename Message>
static void subscribe(ros::NodeHandle& node, double seconds)
{
  std::atomic<int> count(0);
  auto subscriber = node.subscribe<Message>(
      "/bench", 20000, [&](const boost::shared_ptr<Message const>&) { ++count; }, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  ros::AsyncSpinner spinner(1);
  spinner.start();
  std::puts("ready");
  std::fflush(stdout);
  while (count == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  int before = count;
  auto from = Clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  std::printf("%.0f\n", (count - before) / since(from));
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "bench", ros::init_options::AnonymousName);
  ros::NodeHandle node;
  std::string what = argv[1];
  bool text = argc > 2 && std::string(argv[2]) == "std_msgs/String";
  if (what == "publish")
    text ? publish<std_msgs::String>(node, std::atoi(argv[3]), std::atof(argv[4]))
         : publish<sensor_msgs::Image>(node, std::atoi(argv[3]), std::atof(argv[4]));
  else if (what == "subscribe")
    text ? subscribe<std_msgs::String>(node, std::atof(argv[3]))
         : subscribe<sensor_msgs::Image>(node, std::atof(argv[3]));
  else if (what == "serve")
  {
    boost::function<bool(std_srvs::SetBool::Request&, std_srvs::SetBool::Response&)> flip =
        [](std_srvs::SetBool::Request&, std_srvs::SetBool::Response&) { return true; };
    auto server = node.advertiseService("/flip", flip);
    std::puts("ready");
    std::fflush(stdout);
    ros::spin();
  }
  else
  {
    int count = std::atoi(argv[2]);
    auto client = node.serviceClient<std_srvs::SetBool>("/flip", true);
    std_srvs::SetBool call;
    client.waitForExistence();
    bool good = true;
    for (int i = 0; i < count; ++i)
      good &= client.call(call);
    auto from = Clock::now();
    for (int i = 0; i < count; ++i)
      good &= client.call(call);
    if (!good)
    {
      std::fputs("the service failed\n", stderr);
      std::_Exit(1);
    }
    std::printf("%.1f\n", since(from) / count * 1e6);
  }
  std::fflush(stdout);
  std::_Exit(0);
}
