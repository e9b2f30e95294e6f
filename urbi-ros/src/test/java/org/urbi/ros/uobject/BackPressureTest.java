package org.urbi.ros.uobject;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.EndpointQos;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Participant;
import org.urbi.ros.rtps.ParticipantListener;
import org.urbi.ros.rtps.ParticipantOptions;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;
import urbi.UDictionary;

/** Somebody sends faster than urbiscript listens. */
class BackPressureTest extends ScriptsFixture {
  private static final int COUNT = 20_000;

  @ParameterizedTest
  @ValueSource(ints = {0, 1})
  void allAreHeardOrTheNewest(int depth) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Scripts urbi = new Scripts(folder, domain, "");
        Participant other =
            Participant.open(
                ParticipantOptions.loopback(domain.domain()), ParticipantListener.NONE)) {
      urbi.run(
          """
          var Global.heard = 0|;
          var Global.before = -1|;
          var Global.disorder = 0|;
          var Global.topic = Ros.Topic.new("/many")|;
          topic.depth = %d|;
          at (topic.onMessage?(var m))
          {
            if (m["data"] <= before) { disorder += 1 }|
            before = m["data"]|
            heard += 1|
            if (before == %d) { echo("the last one") }
          };
          topic.subscribeAs("std_msgs/Int32");
          """
              .formatted(depth, COUNT - 1));
      send(other);
      urbi.says("the last one");
      String heard = depth == 0 ? "heard == " + COUNT : "heard <= " + COUNT;
      urbi.run("assert { disorder == 0; " + heard + " };");
    }
  }

  private static void send(Participant other) throws InterruptedException {
    CountDownLatch matched = new CountDownLatch(1);
    MessageCodec codec =
        MessageCodec.of(
            new Definitions(Dialect.ROS_2, new InterfaceFiles(List.of()))
                .message("std_msgs/Int32"));
    Writer writer =
        other.writer(
            "rt/many",
            "std_msgs::msg::dds_::Int32_",
            EndpointQos.reliable(EndpointQos.KEEP_ALL),
            new byte[0],
            new WriterListener() {
              @Override
              public void matched(Writer us, EndpointInfo reader) {
                matched.countDown();
              }
            });
    matched.await();
    for (int i = 0; i < COUNT; i++) {
      ByteBuffer next = ByteBuffer.wrap(codec.encode(new UDictionary().with("data", i)));
      while (writer.write(next) == 0) {
        writer.awaitRoom(TimeUnit.SECONDS.toNanos(1));
      }
    }
  }
}
