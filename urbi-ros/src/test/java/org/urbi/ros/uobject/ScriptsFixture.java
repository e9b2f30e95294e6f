package org.urbi.ros.uobject;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;

/** What tests of scripts begin with: the module in a folder, and a program of ROS 2 to talk to. */
abstract class ScriptsFixture {
  @TempDir static Path folder;

  @BeforeAll
  static void writeModule() throws Exception {
    RosJar.writeTo(folder);
  }

  /** What a script and a peer have to say to each other. */
  interface Dialogue {
    void between(Scripts urbi, Peer peer) throws Exception;
  }

  /** Has them talk in a domain of their own. */
  static void talk(String environment, String script, Dialogue dialogue) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.of(environment, domain.domain(), script);
        Scripts urbi = new Scripts(folder, domain, Peer.prefix(environment))) {
      dialogue.between(urbi, peer);
      peer.kill();
    }
  }
}
