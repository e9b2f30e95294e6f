package org.urbi.lang.highlight;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** A text is taken apart into pieces that are coloured. */
class PiecesTest {
  private static String pieces(String text) {
    return Pieces.of(text).stream()
        .map(each -> each.kind() + " " + text.substring(each.begin(), each.end()))
        .collect(Collectors.joining("\n"));
  }

  @Test
  void everyKindIsFound() {
    assertEquals(
        """
        COMMENT /* a /* b */ */
        KEYWORD var
        NAME x
        SYMBOL =
        DURATION 1.5s
        SYMBOL +
        ANGLE 90deg
        SYMBOL *
        NUMBER 0x1F
        SYMBOL ;
        COMMENT // end\
        """,
        pieces("/* a /* b */ */ var x = 1.5s + 90deg * 0x1F; // end"));
    assertEquals(
        """
        STRING "a // b"
        SYMBOL .
        CONTEXTUAL new
        SYMBOL |
        REFUSED static
        NAME 'y z'
        SYMBOL |
        NAME x
        NAME 'd
        KEYWORD and
        REFUSED goto
        INVALID @
        BINARY BIN 2 raw;+-
        SYMBOL ;\
        """,
        pieces("\"a // b\".new | static 'y z' | x'd and goto @ BIN 2 raw;+-;"));
  }

  @Test
  void whatIsNotClosedIsAPieceToTheEnd() {
    assertEquals("NAME a\nSTRING \"b ; c", pieces("a \"b ; c"));
    assertEquals("NAME a\nCOMMENT /* b /* c */ d", pieces("a /* b /* c */ d"));
    assertEquals("", pieces(" \n\t"));
  }

  @Test
  void everythingButBlanksIsInOnePiece() {
    Random random = new Random(1);
    for (int round = 0; round < 2000; round++) {
      String text =
          random
              .ints(20, 0, 22)
              .mapToObj(i -> "a1.'\"\\/*;{}x-+ \n@é_0BIN 3;".substring(i, i + 1))
              .collect(Collectors.joining());
      int at = 0;
      for (Piece piece : Pieces.of(text)) {
        assertEquals("", text.substring(at, piece.begin()).strip(), text);
        at = piece.end();
      }
      assertEquals("", text.substring(at).strip(), text);
    }
  }
}
