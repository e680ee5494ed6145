// SPDX-License-Identifier: Apache-2.0

import assert from "node:assert/strict";

/**
 * Messages that hold until the next of their topic: what each said last, frame after frame. Give it the time of every
 * frame, in order, then end it.
 */
export class HeldMessages {
  #next;
  #last = new Map(); // topic to message
  count = 0; // of messages so far

  constructor(messages, isHeld) {
    this.#next = messages.filter(({ topic }) => isHeld(topic));
  }

  goTo(time) {
    while (this.#next.length > 0 && this.#next[0].time === time) {
      const { topic, value } = this.#next.shift();
      assert.equal(BigInt(value.header.stamp.sec) * 1000000000n + BigInt(value.header.stamp.nanosec), time);
      this.#last.set(topic, value);
      ++this.count;
    }
  }

  of(topic) {
    return this.#last.get(topic);
  }

  end() {
    assert.equal(this.#next.length, 0, "every message belongs to a frame");
  }
}
