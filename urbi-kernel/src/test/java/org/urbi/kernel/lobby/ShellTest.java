package org.urbi.kernel.lobby;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** What a console is told of what it is sent (manual, "Lobby"). */
class ShellTest {
  @Test
  void valuesAreShownAndNothingIsNot() {
    ConsoleTranscript.check(
        """
        1;
        [00000000] 1
        "a";
        [00000000] "a"
        void;
        nil;
        1|;
        var x = 2;
        [00000000] 2
        var y;
        { 3 };
        [00000000] 3
        {};
        1, 2;
        [00000000] 2
        sleep(1ms);
        """);
  }

  @Test
  void statementsInTheBackgroundGoOn() {
    ConsoleTranscript.check(
        """
        { sleep(1s); echo("background") }, echo("foreground");
        [00000000] *** foreground
        sleep(2s);
        [00001000] *** background
        5,
        sleep(1ms);
        """);
  }

  @Test
  void anErrorEndsItsStatementAndNoOther() {
    ConsoleTranscript.check(
        """
        echo(1); missing; echo(2);
        [00000000] *** 1
        [00000000:error] !!! 1.10-16: lookup failed: missing
        [00000000] *** 2
        { echo(3); missing; echo("never") };
        [00000000] *** 3
        [00000000:error] !!! 2.12-18: lookup failed: missing
        missing, echo(4);
        [00000000:error] !!! 3.1-7: lookup failed: missing
        [00000000] *** 4
        sleep(1ms);
        """);
  }

  @Test
  void aStatementMayTakeSeveralLines() {
    ConsoleTranscript.check(
        """
        echo(
          1 +
          2
        );
        [00000000] *** 3
        "one
        two";
        [00000000] "one\\ntwo"
        /* a comment
           of lines */ 3;
        [00000000] 3
        """);
  }

  @Test
  void echoesHaveAChannelAndAPrefix() {
    ConsoleTranscript.check(
        """
        echo("plain");
        [00000000] *** plain
        echo("tagged", "tag");
        [00000000:tag] *** tagged
        Channel.new("mine") << 5;
        [00000000:mine] 5
        Channel.warning << "careful";
        [00000000:warning] careful
        cout << "out"; cerr << "err"; clog << "log";
        [00000000:output] "out"
        [00000000:error] err
        [00000000:clog] "log"
        lobby.send("raw");
        [00000000] raw
        lobby.send("labelled", "label");
        [00000000:label] labelled
        lobby.write("[00000000:direct] bytes\\n");
        [00000000:direct] bytes
        """);
  }

  @Test
  void textsOfSeveralLinesAreContinued() {
    ConsoleTranscript.check(
        """
        echo("one\\ntwo");
        [00000000] *** one
        [:]two
        "a\\nb";
        [00000000] "a\\nb"
        """);
  }

  @Test
  void whatIsLeftWithNothingToLeaveIsRefused() {
    ConsoleTranscript.check(
        """
        return;
        [00000000:error] !!! 1.1-6: syntax error: return: outside a function
        { return 3 };
        [00000000:error] !!! 2.3-10: syntax error: return: outside a function
        break;
        [00000000:error] !!! 3.1-5: syntax error: break: outside a loop
        function f() { return }|;
        f;
        echo("on");
        [00000000] *** on
        """);
  }

  @Test
  void aLobbyKnowsItself() {
    ConsoleTranscript.check(
        """
        lobby === Lobby.lobby;
        [00000000] true
        lobby.isA(Lobby);
        [00000000] true
        lobby.connected;
        [00000000] true
        var Global.mine = 1|;
        var here = 2|;
        lobby.hasLocalSlot("here");
        [00000000] true
        lobby.hasLocalSlot("mine");
        [00000000] false
        lobby.bytesReceived > 100;
        [00000000] true
        """);
  }

  @Test
  void aLobbyIsMadeForOutputElsewhere() {
    ConsoleTranscript.check(
        """
        var l = Lobby.create|;
        l.receive("echo(1);");
        [00000000] *** 1
        sleep(1ms);
        l.connected;
        [00000001] true
        Lobby.new;
        [00000001:error] !!! 5.1-9: new: `Lobby' objects cannot be cloned
        """);
  }
}
