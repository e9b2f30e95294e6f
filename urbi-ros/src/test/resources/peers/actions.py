# A node of ROS 2 that has an action, and uses those of others. Commands come by lines, answers go by lines.
#   serve NAME MODE: pursues goals; refuses those below zero. MODE: count, hang, stubborn (is not cancelled)
#   goal NAME ORDER [COUNT] (waits for so many feedbacks: rclpy may tell of the result first),
#   cancel NAME ORDER (after the first feedback), late NAME ORDER (asks when it has ended),
#   vanish NAME ORDER (sends a goal, and dies when it is accepted)
import os
import sys
import threading
import time

import guard  # noqa: F401
import rclpy
from action_msgs.msg import GoalStatus, GoalStatusArray
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile
from talk import say
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("peer")
kept = []


def serve(name, mode):
    def execute(goal):
        sequence = [0, 1]
        for i in range(1, goal.request.order):
            if goal.is_cancel_requested:
                goal.canceled()
                say("cancelled")
                return Fibonacci.Result(sequence=sequence)
            sequence.append(sequence[i] + sequence[i - 1])
            goal.publish_feedback(Fibonacci.Feedback(sequence=sequence))
            time.sleep(0.05)
        if mode == "hang":
            say("hanging")
            time.sleep(1000)
        if goal.request.order == 0:
            goal.abort()
        else:
            goal.succeed()
        return Fibonacci.Result(sequence=sequence)

    def accept(request):
        return GoalResponse.REJECT if request.order < 0 else GoalResponse.ACCEPT

    def cancel(goal):
        return CancelResponse.REJECT if mode == "stubborn" else CancelResponse.ACCEPT

    kept.append(ActionServer(node, Fibonacci, name, execute, goal_callback=accept, cancel_callback=cancel,
                             callback_group=ReentrantCallbackGroup()))
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)
    threading.Thread(target=executor.spin, daemon=True).start()
    say("serving")


# Goals are sent in one thread: rclpy keeps what an answer belongs to only after it has sent the goal, and drops an
# answer that another thread takes meanwhile.
client_executor = SingleThreadedExecutor()


def until(happened):
    while not happened():
        client_executor.spin_once()


def wait(future):
    until(future.done)
    return future.result()


clients = {}


def sent(name, order, feedback=None):
    # Whoever pursues the goals knows this client by its second one: no feedback gets lost any more.
    if name not in clients:
        clients[name] = ActionClient(node, Fibonacci, name)
    client = clients[name]
    client.wait_for_server()
    return wait(client.send_goal_async(Fibonacci.Goal(order=int(order)), feedback_callback=feedback))


def goal(name, order, count=0):
    feedbacks = []
    handle = sent(name, order, lambda m: feedbacks.append(list(m.feedback.sequence)))
    if not handle.accepted:
        say("refused")
        return
    answer = wait(handle.get_result_async())
    until(lambda: len(feedbacks) >= int(count))
    say(answer.status, list(answer.result.sequence), *feedbacks[-1:])


def cancel(name, order):
    feedbacks = []
    handle = sent(name, order, feedbacks.append)
    until(lambda: feedbacks)
    response = wait(handle.cancel_goal_async())
    answer = wait(handle.get_result_async())
    say(response.return_code, len(response.goals_canceling), answer.status, list(answer.result.sequence))


def late(name, order):
    ended = set()

    def status(array):
        for each in array.status_list:
            if each.status >= GoalStatus.STATUS_SUCCEEDED:
                ended.add(bytes(each.goal_info.goal_id.uuid))

    qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    kept.append(node.create_subscription(GoalStatusArray, name + "/_action/status", status, qos))
    handle = sent(name, order)
    until(lambda: bytes(handle.goal_id.uuid) in ended)
    answer = wait(handle.get_result_async())
    say(answer.status, list(answer.result.sequence))


def vanish(name, order):
    sent(name, order)
    say("vanishing")
    os._exit(1)


for line in sys.stdin:
    words = line.split()
    if words[0] != "serve" and node.executor is None:
        client_executor.add_node(node)
    globals()[words[0]](*words[1:])
os._exit(0)
