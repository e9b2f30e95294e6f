"""What a program does with roslibpy: argv has the port."""
import sys
import threading

import roslibpy

ros = roslibpy.Ros(host="127.0.0.1", port=int(sys.argv[1]))
ros.run()
say = lambda *words: print(*words, flush=True)
say("topic", ros.get_topic_type("/chatter"))
say("services", "/flip" in ros.get_services())
for compression in ("none", "png"):
    heard = threading.Event()
    # It understands no PNG: it hears the same twice.
    topic = roslibpy.Topic(ros, "/chatter", "std_msgs/String", throttle_rate=10, queue_length=1)
    got = []
    topic.subscribe(lambda message: (got.append(message), heard.set()))
    heard.wait()
    say(compression, got[0]["data"])
    topic.unsubscribe()
flip = roslibpy.Service(ros, "/flip", "std_srvs/SetBool")
answer = flip.call(roslibpy.ServiceRequest({"data": True}))
say("flip", '{"success":%s,"message":"%s"}' % (str(answer["success"]).lower(), answer["message"]))
try:
    flip.call(roslibpy.ServiceRequest({"date": True}))
except Exception as error:
    say(error)


def answer_page(request, response):
    response["success"] = request["data"]
    response["message"] = "a page"
    return True


offered = roslibpy.Service(ros, "/page", "std_srvs/SetBool")
offered.advertise(answer_page)
count = roslibpy.ActionClient(ros, "/count", "test_msgs/Fibonacci")
steps = []


def pursue(order):
    ended = []
    done = threading.Event()
    told = lambda result: (ended.append(result), done.set())
    going = lambda feedback: (steps.append(feedback), order >= 100 and count.cancel_goal(goal))
    goal = count.send_goal(roslibpy.Goal({"order": order}), told, going, told)
    done.wait()
    return ended[0]


result = pursue(1)
say("goal", '{"sequence":%s}' % str(result["values"]["sequence"]).replace(" ", ""), len(steps))
result = pursue(100)
say("goal", "%s: %s" % (result["status"].name, str(result["values"]["sequence"])), len(steps))
result = pursue(-1)
say("goal", "%s: %s" % (result["status"].name, result["values"]), len(steps))
said = roslibpy.Topic(ros, "/said", "std_msgs/String")
said.advertise()
said.publish(roslibpy.Message({"data": "by a page"}))
say("ready")
sys.stdin.read(1)
ros.terminate()
