package org.urbi.server.trust;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.time.VirtualClock;
import org.urbi.kernel.trust.Role;
import org.urbi.server.options.Failure;

class TokensTest {
  @TempDir Path directory;

  private Path file(String text, String permissions) throws IOException {
    Path file = directory.resolve("tokens");
    Files.writeString(file, text);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
    return file;
  }

  @Test
  void tokensAndHashesOfTokensAreFound() throws IOException {
    // printf %s correct-horse-battery | sha256sum
    String hash = "62249369389075490555a758353aec61500c6218fa597252d52dc4bd0148f12d";
    Tokens tokens =
        Tokens.read(
            file(
                "# who\n\nowner 0123456789abcdef the boss\nobserver sha256:" + hash + " screen\n",
                "rw-------"));
    assertEquals(new Tokens.TokenHolder(Role.OWNER, "the boss"), tokens.holder("0123456789abcdef"));
    assertEquals(
        new Tokens.TokenHolder(Role.OBSERVER, "screen"), tokens.holder("correct-horse-battery"));
    assertNull(tokens.holder("0123456789abcdeF"));
    assertNull(tokens.holder(""));
    // The hash itself is no token.
    assertNull(tokens.holder(hash));
    assertNull(tokens.holder("sha256:" + hash));
  }

  @ParameterizedTest
  @ValueSource(strings = {"rw-r-----", "rw----r--", "rw-rw----", "rw-rw-rw-"})
  void tokenFileThatOthersCanReadIsRefused(String permissions) throws IOException {
    Path file = file("owner 0123456789abcdef\n", permissions);
    assertTrue(
        assertThrows(IOException.class, () -> Tokens.read(file)).getMessage().contains("chmod"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "# nothing\n",
        "king 0123456789abcdef\n",
        "owner\n",
        "owner short\n",
        "owner sha256:12\n",
        "owner sha256:xyz\n"
      })
  void invalidTokenFileIsRefusedWithoutShowingTokens(String text) throws IOException {
    Path file = file(text, "rw-------");
    String message = assertThrows(IOException.class, () -> Tokens.read(file)).getMessage();
    assertFalse(message.contains("0123456789abcdef"), message);
  }

  @Test
  void eachWrongTokenDoublesTheDelayOfItsAddress() {
    VirtualClock clock = new VirtualClock();
    TokenThrottle wrong = new TokenThrottle(clock);
    assertEquals(0, wrong.secondsToWait("a"));
    long expected = 1;
    for (int i = 0; i < 10; i++) {
      wrong.recordFailure("a", "token " + i);
      assertEquals(expected, wrong.secondsToWait("a"));
      assertEquals(0, wrong.secondsToWait("b"));
      clock.advanceTo(clock.now() + expected * 1_000_000_000L);
      assertEquals(0, wrong.secondsToWait("a"));
      expected = Math.min(expected * 2, 64);
    }
    wrong.recordFailure("a", "last");
    wrong.recordSuccess("a");
    assertEquals(0, wrong.secondsToWait("a"));
    wrong.recordFailure("a", "one more");
    assertEquals(1, wrong.secondsToWait("a"));
    for (int i = 0; i < 100_000; i++) {
      wrong.recordFailure("address " + i, "token");
    }
    assertTrue(wrong.secondsToWait("address 99999") > 0);
  }

  @Test
  void fewWrongTokensAreRemembered() {
    TokenThrottle wrong = new TokenThrottle(new VirtualClock());
    for (int i = 0; i < 100; i++) {
      wrong.recordFailure("a", "token " + i);
    }
    assertTrue(wrong.isKnown("a", "token 99"));
    assertTrue(wrong.isKnown("a", "token 96"));
    assertFalse(wrong.isKnown("a", "token 95"));
    assertFalse(wrong.isKnown("b", "token 99"));
    wrong.recordSuccess("a");
    assertTrue(wrong.isKnown("a", "token 99"), "it has not become right");
  }

  @Test
  void otherMachinesNeedATokenOrTheInsecureOption() throws IOException {
    InetSocketAddress everywhere = new InetSocketAddress("0.0.0.0", 0);
    InetSocketAddress here = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    AccessOptions open = new AccessOptions(AccessPolicy.ALL, null, false);
    assertNull(open.checkAddress(here));
    assertTrue(
        assertThrows(Failure.class, () -> open.checkAddress(everywhere))
            .getMessage()
            .contains("--insecure"));
    assertTrue(
        new AccessOptions(AccessPolicy.ALL, null, true)
            .checkAddress(everywhere)
            .contains("without a token"));
    Tokens tokens = Tokens.read(file("user 0123456789abcdef\n", "rw-------"));
    assertNull(
        new AccessOptions(new AccessPolicy(tokens, null), null, false).checkAddress(everywhere));
  }
}
