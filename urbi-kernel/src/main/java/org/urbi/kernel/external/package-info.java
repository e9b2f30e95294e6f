/**
 * Processes linked with the SDK of Urbi 2.7: they declare their UObjects by statements of
 * urbiscript (docs/protocol.md).
 */
@NullMarked
package org.urbi.kernel.external;

import org.jspecify.annotations.NullMarked;
