package urbi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class UMessageReaderTest {
  private final List<String> messages = new ArrayList<>();

  private UMessageReader reader() {
    messages.clear();
    return new UMessageReader((time, tag, type, raw, continuation) ->
        messages.add(
            (continuation ? "+" : "")
                + time
                + "|"
                + tag
                + "|"
                + type.name().charAt(8)
                + "|"
                + new String(raw, StandardCharsets.ISO_8859_1)));
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  private static final String STREAM =
      "[00000001] 42\n"
          + "[00000002:tag] \"BIN 5\"\r\n"
          + "[00000003:error] !!! 1.1-3: lookup failed: foo\n"
          + "[00000003:error] !!!    called from: x\n"
          + "[00000004] *** BIN 9 is text\n"
          + "second line BIN 3\n"
          + "[00000005] BIN 7 my header\n\n[0001]\"\n"
          + "[00000006:t] [1, BIN 3\n;\n\u00ff, \"BIN 3\", BIN 0\n]\n"
          + "[123456789:a b]no blank\n"
          + "[00000007]\n"
          + "[00000008] CABIN 4\n";

  private static final List<String> MESSAGES =
      List.of(
          "1||D|42",
          "2|tag|D|\"BIN 5\"",
          "3|error|E|!!! 1.1-3: lookup failed: foo",
          "3|error|E|!!!    called from: x",
          "4||S|*** BIN 9 is text",
          "+4||S|second line BIN 3",
          "5||D|BIN 7 my header\n\n[0001]",
          "6|t|D|[1, BIN 3\n;\n\u00ff, \"BIN 3\", BIN 0\n]",
          "123456789|a b|D|no blank",
          "7||D|",
          "8||D|CABIN 4");

  @Test
  void messagesAreCutWhateverThePackets() {
    // The data of the fifth are seven bytes: the quote behind them is text.
    List<String> expected = new ArrayList<>(MESSAGES);
    expected.set(6, "5||D|BIN 7 my header\n\n[0001]\"");
    byte[] stream = bytes(STREAM);
    for (int size = 1; size <= stream.length; size++) {
      UMessageReader reader = reader();
      for (int at = 0; at < stream.length; at += size) {
        reader.feed(stream, at, Math.min(stream.length, at + size));
      }
      assertEquals(expected, messages);
    }
    for (int split = 1; split < stream.length; split++) {
      UMessageReader reader = reader();
      reader.feed(stream, 0, split);
      reader.feed(stream, split, stream.length);
      assertEquals(expected, messages);
    }
  }

  @Test
  void garbageIsTextOrRefused() {
    Random random = new Random(1);
    for (int i = 0; i < 200; i++) {
      byte[] garbage = new byte[2000];
      random.nextBytes(garbage);
      UMessageReader reader = reader();
      reader.feed(garbage, 0, garbage.length);
      reader.feed(bytes("\n[00000001] 1\n"), 0, 14);
      assertEquals("1||D|1", messages.getLast());
    }
    byte[] large = bytes("[00000001] BIN 99999999999 x\n");
    UMessageReader reader = reader();
    assertThrows(UParseException.class, () -> reader.feed(large, 0, large.length));
  }
}
