#!/usr/bin/python3
"""A node of rospy with the action /count, which then has /ours pursue goals, if its argument says so."""
import sys
import threading
import time

import actionlib
import rospy
from actionlib.msg import TestAction, TestFeedback, TestGoal, TestResult

rospy.init_node('goals', disable_signals=True)
waiting = {}


def goal(handle):
    order = handle.get_goal().goal
    if order < 0:
        handle.set_rejected(text='never')
        return
    handle.set_accepted()
    handle.publish_feedback(TestFeedback(1))
    if order == 0:
        handle.set_aborted(TestResult(5))
    elif order < 100:
        handle.set_succeeded(TestResult(order))
    else:
        waiting[handle.get_goal_id().id] = handle


def cancel(handle):
    if handle.get_goal_id().id in waiting:
        handle.set_canceled(TestResult(7))


server = actionlib.ActionServer('/count', TestAction, goal, cancel, auto_start=False)
server.start()
print('ready', flush=True)
if 'goals' in sys.argv:
    # Not the simple client: it drops an end that comes before it has stored the goal's handle.
    client = actionlib.ActionClient('/ours', TestAction)
    client.wait_for_server()
    for order in (3, -1, 0, 1000):
        told = []
        going = threading.Event()
        handle = client.send_goal(TestGoal(order), feedback_cb=lambda handle, feedback: (
            told.append(feedback.feedback), going.set()))
        if order == 1000:
            going.wait()
            print('told', told[0], flush=True)
            # Feedback and status come on ways of their own. Once it is asked to cancel, actionlib takes a goal
            # for lost that is not yet in the status it hears next, which may have been told before the goal came.
            while handle.get_comm_state() != actionlib.CommState.ACTIVE:
                time.sleep(0.005)
            handle.cancel()
        while handle.get_comm_state() != actionlib.CommState.DONE:
            time.sleep(0.005)
        print('goal', order, 'state', handle.get_terminal_state(), 'result', handle.get_result().result, flush=True)
threading.Event().wait()
