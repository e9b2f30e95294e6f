/** Pages for browsers: files, a stream of messages, and a guard against pages of other sites. */
@NullMarked
package org.urbi.web;

import org.jspecify.annotations.NullMarked;
